// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_session.hpp"

#include "app/pages/explore/extraction_words.hpp"
#include "app/pages/explore/face_tour.hpp"
#include "app/pages/explore/feature_labels.hpp"
#include "app/pages/explore/place_words.hpp"
#include "app/pages/explore/zoom_steps.hpp"
#include "core/guidance/exact_law.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QVariantMap>

#include <algorithm>

namespace tp {

namespace {
constexpr int poll_ms = 16;
constexpr int sheet_settles_ms = 300; ///< a window that is moved or made larger tells of each step
constexpr double breath_s = 0.3; ///< between a feature's name and its tour

Rect around(const Rect& a, const Rect& b) { return {glm::min(a.min, b.min), glm::max(a.max, b.max)}; }
} // namespace

ExploreSession::ExploreSession(Narrator& narrator, EarconPlayer& earcons, SonifiedGuide& guide,
                               Preferences& preferences, ExploreSettings settings)
    : settings_(std::move(settings)), frame_{settings_.surface.width_mm, settings_.surface.height_mm},
      narrator_(narrator), earcons_(earcons), guide_(guide), preferences_(preferences),
      servo_(settings_.surface, settings_.servo, settings_.plant), dwell_(settings_.dwell_s), desk_(settings_.devices) {
    pointer_ = finger_ = frame_.from_surface(Vec2(0.0));
    servo_.set_max_force(maxForce());
    connect(&loader_, &PhotoLoader::loaded, this, &ExploreSession::show);
    connect(&narrator_, &Narrator::changed, this, &ExploreSession::voiceChanged);
    connect(&preferences_, &Preferences::changed, this, &ExploreSession::choices_changed);
    connect(&desk_, &DeviceDesk::looked, this, &ExploreSession::devices_seen);
    connect(&desk_, &DeviceDesk::opened, this,
            [this](const std::shared_ptr<OpenDevice>& open) { use_device(*open); });
    connect(&desk_, &DeviceDesk::refused, this, &ExploreSession::device_refused);
    sheet_settles_.setSingleShot(true);
    sheet_settles_.setInterval(sheet_settles_ms);
    connect(&sheet_settles_, &QTimer::timeout, this, &ExploreSession::follow_sheet);
    timer_.setInterval(poll_ms);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &ExploreSession::poll);
    clock_.start();
    QCoreApplication::instance()->installEventFilter(this);
}

ExploreSession::~ExploreSession() { guide_.silence(); }

double ExploreSession::now() const {
    return settings_.now ? settings_.now() : 1e-9 * static_cast<double>(clock_.nsecsElapsed());
}

void ExploreSession::tell(const QString& sentence, Priority priority) {
    if (sentence_ != sentence) {
        sentence_ = sentence;
        emit sentenceChanged();
    }
    if (here_)
        narrator_.tell(sentence, priority);
    clock_guide_.busy_until(now() + speech_seconds(sentence, speech_rate(preferences_.choices().rate)));
}

/// A word to the finger that the page need not show.
void ExploreSession::murmur(const QString& words) {
    narrator_.tell(words, Priority::touch);
    clock_guide_.busy_until(now() + speech_seconds(words, speech_rate(preferences_.choices().rate)));
}

void ExploreSession::tellProblem(const QString& sentence) {
    earcons_.play(Earcon::error);
    tell(sentence, Priority::message);
}

QString ExploreSession::person_of(std::size_t face) const {
    return photo_ && face < photo_->names.size() ? photo_->names[face] : QString();
}

QString ExploreSession::name_of_face(std::size_t face) const {
    const QString person = person_of(face);
    if (!person.isEmpty())
        return person;
    return faceCount() == 1 ? tr("the face") : tr("face %1").arg(face + 1);
}

QString ExploreSession::label_of(int feature) const {
    if (feature < 0 || feature >= static_cast<int>(features_.size()))
        return {};
    const SceneFeature& one = features_[static_cast<std::size_t>(feature)];
    const bool several = !subject_.face && faceCount() > 1;
    return feature_label(one.name, person_of(one.face), several ? static_cast<int>(one.face) + 1 : 0);
}

QString ExploreSession::title() const {
    QStringList people;
    if (photo_)
        people = QStringList(photo_->names.begin(), photo_->names.end());
    people.removeAll(QString());
    return people.isEmpty() ? photoName() : listed(people);
}

// --- the page ---

/// The texts are asked for anew in another language.
bool ExploreSession::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::LanguageChange && watched == QCoreApplication::instance()) {
        if (state_ == State::Ready)
            list_faces();
        emit sceneChanged();
        emit featureChanged();
        emit modeChanged();
        emit choicesChanged();
    }
    return QObject::eventFilter(watched, event);
}

QString ExploreSession::where_one_is() const {
    switch (state_) {
    case State::Empty:
        return tr("There is no photograph yet. Press O, or the button Open photograph, to choose one.");
    case State::Looking:
        return tr("Looking for faces…");
    case State::Ready:
        return describe(photo_->extraction, photo_->names);
    case State::Problem:
        return found_;
    }
    return {};
}

void ExploreSession::enter() {
    const bool was_here = here_;
    here_ = true;
    hushed_ = false;
    want_device();
    if (was_here && state_ == State::Looking)
        return; // just told
    if (state_ == State::Ready && force_wanted_) {
        servo_.engage();
        emit modeChanged();
    }
    if (state_ == State::Ready)
        tell(tr("Explore. %1 Move a finger over the picture; W tells where it is.").arg(where_one_is()),
             Priority::message);
    else
        tell(tr("Explore. %1").arg(where_one_is()), Priority::message);
}

void ExploreSession::leave() {
    if (!here_)
        return;
    force_wanted_ = engaged() || state_ != State::Ready;
    stop_everything();
    leave_device();
    here_ = false;
}

// --- the photograph ---

void ExploreSession::open(const QUrl& file) {
    if (file.isLocalFile())
        open_file(file.toLocalFile());
    else
        tellProblem(tr("Only a photograph that is a file on this computer can be opened."));
}

QUrl ExploreSession::picturesFolder() const {
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    return QUrl::fromLocalFile(QFileInfo(pictures).isDir() ? pictures : QDir::homePath());
}

void ExploreSession::open_file(const QString& file) {
    timer_.stop();
    stop_everything();
    servo_.clear();
    law_.reset();
    subject_ = {};
    faces_.clear();
    features_.clear();
    face_rects_.clear();
    become(State::Looking);
    tell(tr("Looking for faces…"), Priority::message);
    loader_.load(file);
}

void ExploreSession::become(State state) {
    state_ = state;
    set_feature(-1);
    last_feature_ = -1;
    force_ = {};
    lift();
    emit photoChanged();
    emit sceneChanged();
    emit handMoved();
    emit modeChanged();
}

ExtraFeatures ExploreSession::extras() const {
    const Choices& choices = preferences_.choices();
    const ExtraFeatures& more = settings_.extras;
    return {choices.brows || more.brows, choices.nose || more.nose, choices.irises || more.irises};
}

void ExploreSession::show(std::shared_ptr<const LoadedPhoto> photo) {
    loaded_ = std::move(photo);
    auto shown = std::make_shared<LoadedPhoto>(*loaded_);
    shown->extraction = with_extras(std::move(shown->extraction), extras());
    photo_ = std::move(shown);
    subject_ = {};
    build(true);
    if (state_ == State::Ready && here_)
        earcons_.play(Earcon::ready);
    found_ = describe(photo_->extraction, photo_->names);
    if (photo_->image.isNull() && !photo_->name.isEmpty())
        found_ = tr("%1: %2").arg(photo_->name, found_);
    tell(found_, Priority::message);
}

/// From the photograph and the chosen subject to what is felt. `fresh`: as if nothing had been felt before.
void ExploreSession::build(bool fresh) {
    timer_.stop();
    faces_.clear();
    features_.clear();
    face_rects_.clear();
    law_.reset();
    const Extraction& extraction = photo_->extraction;
    const Result<BuiltScene> built = build_scene(extraction, settings_.surface, subject_);
    if (!built || !servo_.show(built->scene).empty()) {
        servo_.clear();
        const double height = frame_.height_mm;
        const double aspect =
            photo_->image.isNull() ? 1.0 : photo_->image.width() / double(photo_->image.height());
        photo_rect_ = QRectF(0.5 * (frame_.width_mm - aspect * height), 0.0, aspect * height, height);
        become(State::Problem);
        return;
    }
    law_ = std::make_unique<ExactLaw>(servo_.felt(), TentProfile{});
    features_ = built->features;
    // Places in the picture count from the centre of its first pixel.
    const Rect corners{built->photo_to_surface(Vec2(-0.5)),
                       built->photo_to_surface(Vec2(extraction.width - 0.5, extraction.height - 0.5))};
    photo_rect_ = frame_.from_surface(corners);
    photo_to_surface_ = built->photo_to_surface;
    list_faces();
    servo_.place(fresh ? Vec2(0.0) : servo_.pointer());
    if (fresh && here_)
        servo_.engage();
    if (fresh) {
        force_wanted_ = true;
        hushed_ = false;
    }
    hand_.reset();
    become(State::Ready);
    timer_.start();
    if (fresh)
        devices_seen();
}

void ExploreSession::list_faces() {
    faces_.clear();
    face_rects_.clear();
    const std::vector<Face>& faces = photo_->extraction.faces;
    const QRectF sheet(0.0, 0.0, frame_.width_mm, frame_.height_mm);
    const auto on_sheet = [&](const Rect& box) { return frame_.from_surface(box).intersected(sheet); };
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Vec2 a = photo_to_surface_(faces[i].box.min);
        const Vec2 b = photo_to_surface_(faces[i].box.max);
        const Rect box{glm::min(a, b), glm::max(a, b)};
        Rect whole = box;
        for (const Contour& contour : faces[i].contours)
            whole = around(whole, bounds_of(flatten(mapped(contour, photo_to_surface_)).points));
        face_rects_.push_back(whole);
        QVariantList features;
        for (std::size_t k = 0; k < features_.size(); ++k)
            if (features_[k].face == i)
                features << QVariantMap{{"index", static_cast<int>(k)},
                                        {"name", label_of(static_cast<int>(k))},
                                        {"rect", on_sheet(bounds_of(servo_.felt().lines[k].points))}};
        const bool nameless = faces.size() == 1 && person_of(i).isEmpty();
        faces_ << QVariantMap{{"name", nameless ? tr("face") : name_of_face(i)},
                              {"rect", on_sheet(box)},
                              {"chosen", subject_.face == i},
                              {"features", features}};
    }
}

// --- zoom ---

QString ExploreSession::zoom_sentence() const {
    if (subject_ == Subject{})
        return faceCount() == 1 ? tr("Zoomed out to the whole face.")
                                : tr("Zoomed out to all %n face(s).", nullptr, faceCount());
    const bool named = faceCount() > 1 || !person_of(*subject_.face).isEmpty();
    const QString person = name_of_face(*subject_.face);
    switch (subject_.part) {
    case FacePart::whole:
        break;
    case FacePart::eyes:
        return named ? tr("Zoomed to the eyes of %1.").arg(person) : tr("Zoomed to the eyes.");
    case FacePart::left_eye:
        return named ? tr("Zoomed to the left eye of %1.").arg(person) : tr("Zoomed to the left eye.");
    case FacePart::right_eye:
        return named ? tr("Zoomed to the right eye of %1.").arg(person) : tr("Zoomed to the right eye.");
    case FacePart::mouth:
        return named ? tr("Zoomed to the mouth of %1.").arg(person) : tr("Zoomed to the mouth.");
    }
    return tr("Zoomed to %1.").arg(person);
}

void ExploreSession::zoom_to(const Subject& subject) {
    if (touring())
        end_tour({});
    const Subject before = subject_;
    subject_ = subject;
    if (!build_scene(photo_->extraction, settings_.surface, subject).ok()) {
        subject_ = before;
        return tellProblem(tr("This part is too small in the picture to zoom to it."));
    }
    build(false);
    tracker_.set(-1);
    const int here = FeatureTracker().follow(servo_.felt(), felt_place());
    set_feature(here); // told with the zoom, which it would cut short a moment later
    tell(here < 0 ? zoom_sentence() : tr("%1 %2.").arg(zoom_sentence(), at_the_start(label_of(here))), Priority::touch);
    zoomed_at_ = now();
    zoomed_from_ = servo_.finger();
    zoom_told_at_ = zoomed_at_ + speech_seconds(sentence_, speech_rate(preferences_.choices().rate));
}

bool ExploreSession::tells_a_zoom(double now) const {
    const bool rests = servo_.real() ? length(servo_.finger() - zoomed_from_) < TentProfile{}.band() // as far as a force draws
                                     : moved_at_ <= zoomed_at_;
    return now < zoom_told_at_ && rests;
}

void ExploreSession::zoomIn() {
    if (state_ != State::Ready)
        return whereAmI();
    const int face = face_at(face_rects_, felt_place());
    const int nearest = law_->at(felt_place()).contour;
    const std::size_t here = face >= 0      ? static_cast<std::size_t>(face)
                             : nearest >= 0 ? features_[static_cast<std::size_t>(nearest)].face
                                            : 0;
    zoom_to(zoomed_in(photo_->extraction, subject_, here));
}

void ExploreSession::zoomOut() {
    if (state_ != State::Ready)
        return whereAmI();
    if (const std::optional<Subject> out = zoomed_out(photo_->extraction, subject_))
        return zoom_to(*out);
    earcons_.play(Earcon::list_end);
    tell(tr("This is the whole picture."), Priority::touch);
}

void ExploreSession::zoomHere(double x, double y) {
    if (state_ != State::Ready)
        return whereAmI();
    constexpr double reach_mm = 8.0;
    const Vec2 place = frame_.to_surface({x, y});
    const int face = face_at(face_rects_, place);
    int feature = -1;
    for (std::size_t i = 0; i < features_.size(); ++i) { // inside a ring one is at it, however far its line is
        const Rect box = bounds_of(servo_.felt().lines[i].points);
        const Rect grown{box.min - Vec2(reach_mm), box.max + Vec2(reach_mm)};
        if (features_[i].name != feature::outline && grown.contains(place) &&
            (feature < 0 || distance_to(servo_.felt().lines[i], place) <
                                distance_to(servo_.felt().lines[static_cast<std::size_t>(feature)], place)))
            feature = static_cast<int>(i);
    }
    if (face < 0 && feature < 0)
        return zoomOut();
    const SceneFeature there = feature >= 0 ? features_[static_cast<std::size_t>(feature)]
                                            : SceneFeature{static_cast<std::size_t>(face), {}};
    if (const std::optional<Subject> nearer = zoomed_to(photo_->extraction, subject_, there))
        return zoom_to(*nearer);
    earcons_.play(Earcon::list_end);
    tell(tr("There is nothing nearer to zoom to here."), Priority::touch);
}

void ExploreSession::chooseFace(int index) {
    if (state_ != State::Ready || index >= faceCount())
        return;
    zoom_to(index < 0 ? Subject{} : Subject{static_cast<std::size_t>(index), FacePart::whole});
}

void ExploreSession::nextFace() {
    const int next = subject_.face ? static_cast<int>(*subject_.face) + 1 : 0;
    chooseFace(next < faceCount() ? next : -1);
}

// --- tour and force ---

int ExploreSession::tour_feature() const {
    if (tracker_.current() >= 0)
        return tracker_.current();
    if (last_feature_ >= 0)
        return last_feature_;
    return std::max(0, law_->at(felt_place()).contour);
}

void ExploreSession::toggleTour() {
    if (state_ != State::Ready)
        return whereAmI();
    if (touring())
        return end_tour(tr("Tour ended."));
    if (!engaged())
        return tell(tr("The force is off. Press Enter to switch it on."), Priority::touch);
    const int index = tour_feature();
    grab_from_ = hand_;
    last_feature_ = index;
    tell(tr("Tour round the %1.").arg(label_of(index)), Priority::touch);
    servo_.lead_along(static_cast<std::size_t>(index));
    emit modeChanged();
}

void ExploreSession::toggleFaceTour() {
    if (state_ != State::Ready)
        return whereAmI();
    if (touring())
        return end_tour(tr("Tour ended."));
    if (!engaged())
        return tell(tr("The force is off. Press Enter to switch it on."), Priority::touch);
    const std::size_t face = features_[static_cast<std::size_t>(tour_feature())].face;
    const std::vector<int> order = tour_order(features_, face);
    tour_left_.assign(order.begin(), order.end());
    grab_from_ = hand_;
    tell(tr("Tour of %1: %n feature(s). %2.", nullptr, static_cast<int>(order.size()))
             .arg(name_of_face(face), at_the_start(feature_word(features_[static_cast<std::size_t>(order.front())].name))),
         Priority::message);
    tour_goes_on_at_ = now() + speech_seconds(sentence_, speech_rate(preferences_.choices().rate)) + breath_s;
    emit modeChanged();
}

/// What comes next on a tour: the finger is led when the feature's name has been spoken, and let go at its end.
void ExploreSession::lead_on(double now) {
    if (servo_.leads() && servo_.has_led()) {
        if (tour_left_.empty())
            return end_tour(tr("Tour finished."));
        servo_.let_go();
        const SceneFeature& next = features_[static_cast<std::size_t>(tour_left_.front())];
        tell(tr("%1.").arg(at_the_start(feature_word(next.name))), Priority::message);
        tour_goes_on_at_ = now + speech_seconds(sentence_, speech_rate(preferences_.choices().rate)) + breath_s;
    } else if (!servo_.leads() && !tour_left_.empty() && now >= tour_goes_on_at_) {
        last_feature_ = tour_left_.front();
        tour_left_.pop_front();
        servo_.lead_along(static_cast<std::size_t>(last_feature_));
    }
}

void ExploreSession::end_tour(const QString& sentence) {
    servo_.let_go();
    tour_left_.clear();
    tour_progress_ = 0.0;
    grab_from_.reset();
    guide_.silence();
    emit modeChanged();
    if (!sentence.isEmpty())
        tell(sentence, Priority::message);
}

void ExploreSession::stop_everything() {
    servo_.disengage();
    servo_.let_go();
    tour_left_.clear();
    tour_progress_ = 0.0;
    guide_.silence();
    hushed_ = true;
    narrator_.stop();
    emit modeChanged();
}

/// Back to what was open before.
void ExploreSession::stop_looking() {
    loader_.cancel();
    if (!photo_) {
        become(State::Empty);
        return tell(tr("Stopped looking. Press O to open a photograph."), Priority::touch);
    }
    build(true);
    stop_everything();
    tell(state_ == State::Ready
             ? tr("Stopped looking. %1 is open again. The force is off. Press Enter to switch it on.").arg(photo_->name)
             : tr("Stopped looking. %1 is open again.").arg(photo_->name),
         Priority::touch);
}

bool ExploreSession::stop() {
    if (state_ == State::Looking) {
        stop_looking();
        return true;
    }
    const bool something = state_ == State::Ready && (engaged() || touring() || guide_.sounds());
    if (!something) {
        narrator_.stop();
        return false;
    }
    stop_everything();
    tell(tr("Stopped. The force is off. Press Enter to switch it on."), Priority::touch);
    return true;
}

void ExploreSession::stopOrStart() {
    if (!stop())
        engage();
}

void ExploreSession::engage() {
    if (state_ != State::Ready)
        return;
    hushed_ = false;
    refused_.clear();
    device_expected_ = true; // where one was refused, it is asked again
    servo_.engage();
    emit modeChanged();
    tell(tr("The force is on."), Priority::touch);
    devices_seen();
}

void ExploreSession::whereAmI() {
    if (state_ != State::Ready)
        return tell(where_one_is(), Priority::touch);
    const Vec2 place = felt_place();
    const Guidance guidance = law_->at(place);
    if (guidance.contour < 0)
        return tell(tr("There is nothing to feel here."), Priority::touch);
    const auto index = static_cast<std::size_t>(guidance.contour);
    const SceneFeature& nearest = features_[index];
    const Rect box = bounds_of(servo_.felt().lines[index].points);
    Whereabouts where;
    where.person = name_of_face(nearest.face);
    where.beside = !face_rects_[nearest.face].contains(place);
    where.feature = feature_word(nearest.name);
    where.on_it = guidance.distance <= FeatureTracker::enter_mm;
    const Vec2 way = where.on_it ? place - box.centre() : guidance.nearest - place;
    where.hour = clock_direction(way);
    where.millimetres = static_cast<int>(std::lround(length(way)));
    tell(where_am_i(where), Priority::touch);
}

// --- what the person has chosen ---

double ExploreSession::maxForce() const {
    return std::clamp(preferences_.choices().max_force_n, 0.0, settings_.servo.limits.max_force);
}

void ExploreSession::setMaxForce(double newtons) {
    preferences_.change([&](Choices& choices) { choices.max_force_n = std::clamp(newtons, 0.1, 1.5); });
}

QStringList ExploreSession::guideNames() const {
    return {tr("None"), tr("Sonar"), tr("Clock voice"), tr("Both")};
}

void ExploreSession::setGuide(int guide) {
    if (guide >= 0 && guide < guideNames().size())
        preferences_.change([&](Choices& choices) { choices.guide = static_cast<Choices::Guide>(guide); });
}

void ExploreSession::nextGuide() {
    setGuide((guide() + 1) % static_cast<int>(guideNames().size()));
    tell(tr("Guide: %1.").arg(guideNames()[guide()]), Priority::touch);
}

void ExploreSession::setVoiceOn(bool on) {
    narrator_.set_voice_on(on);
    preferences_.change(
        [&](Choices& choices) { choices.voice = on ? Choices::Voice::program : Choices::Voice::screen_reader; });
}

void ExploreSession::choices_changed() {
    servo_.set_max_force(maxForce());
    if (!guides())
        guide_.silence();
    if (state_ == State::Ready && loaded_) {
        const Extraction wanted = with_extras(Extraction(loaded_->extraction), extras());
        const auto count = [](const Extraction& extraction) {
            std::size_t contours = 0;
            for (const Face& face : extraction.faces)
                contours += face.contours.size();
            return contours;
        };
        if (count(wanted) != count(photo_->extraction)) {
            auto shown = std::make_shared<LoadedPhoto>(*loaded_);
            shown->extraction = wanted;
            photo_ = std::move(shown);
            if (touring())
                end_tour({});
            build(false);
        }
    }
    emit choicesChanged();
}

} // namespace tp
