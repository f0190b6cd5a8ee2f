// SPDX-License-Identifier: Apache-2.0
#include "app/explore/explore_session.hpp"

#include "app/explore/extraction_words.hpp"
#include "app/explore/place_words.hpp"
#include "app/scene/feature_words.hpp"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QVariantMap>

#include <algorithm>

namespace tp {

namespace {
constexpr int poll_ms = 16;
constexpr double grab_mm = 5.0; ///< a hand that moves farther during a tour wants to lead itself
const QString force_is_off = "The force is off. Press Enter to switch it on.";
} // namespace

ExploreSession::ExploreSession(Narrator& narrator, ExploreSettings settings)
    : settings_(settings), frame_{settings.surface.width_mm, settings.surface.height_mm},
      narrator_(narrator), servo_(settings.surface, settings.servo, settings.plant), max_force_(settings.servo.limits.max_force) {
    pointer_ = finger_ = frame_.from_surface(Vec2(0.0));
    connect(&loader_, &PhotoLoader::loaded, this, &ExploreSession::show);
    connect(&narrator_, &Narrator::changed, this, &ExploreSession::voiceChanged);
    timer_.setInterval(poll_ms);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &ExploreSession::poll);
    clock_.start();
}

void ExploreSession::tell(const QString& sentence, Priority priority) {
    if (sentence_ != sentence) {
        sentence_ = sentence;
        emit sentenceChanged();
    }
    narrator_.tell(sentence, priority);
}

void ExploreSession::tellProblem(const QString& sentence) { tell(sentence, Priority::message); }

QString ExploreSession::name_of(int feature) const {
    const FlatScene& felt = servo_.felt();
    if (feature < 0 || feature >= static_cast<int>(felt.names.size()))
        return {};
    return QString::fromStdString(spoken_feature(felt.names[static_cast<std::size_t>(feature)]));
}

// --- the photograph ---

void ExploreSession::open(const QUrl& file) {
    if (file.isLocalFile())
        open_file(file.toLocalFile());
    else
        tellProblem("Only a photograph that is a file on this computer can be opened.");
}

QUrl ExploreSession::picturesFolder() const {
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    return QUrl::fromLocalFile(QFileInfo(pictures).isDir() ? pictures : QDir::homePath());
}

void ExploreSession::open_file(const QString& file) {
    timer_.stop();
    stop_everything();
    servo_.clear();
    chosen_face_.reset();
    faces_.clear();
    become(State::Looking);
    tell("Looking for faces…", Priority::message);
    loader_.load(file);
}

void ExploreSession::become(State state) {
    state_ = state;
    set_feature(-1);
    last_feature_ = -1;
    force_ = {};
    emit photoChanged();
    emit sceneChanged();
    emit handMoved();
    emit modeChanged();
}

void ExploreSession::show(std::shared_ptr<const LoadedPhoto> photo) {
    auto shown = std::make_shared<LoadedPhoto>(*photo);
    shown->extraction = with_extras(std::move(shown->extraction), settings_.extras);
    photo_ = std::move(shown);
    chosen_face_.reset();
    build();
    const QString found = describe(photo_->extraction);
    tell(photo_->image.isNull() && !photo_->name.isEmpty() ? photo_->name + ": " + found : found,
         Priority::message);
}

/// From the photograph and the chosen face to what is felt.
void ExploreSession::build() {
    timer_.stop();
    servo_.clear();
    faces_.clear();
    const Extraction& extraction = photo_->extraction;
    const Result<BuiltScene> built = build_scene(extraction, settings_.surface, chosen_face_);
    if (!built || !servo_.show(built->scene).empty()) {
        const double height = frame_.height_mm;
        const double aspect =
            photo_->image.isNull() ? 1.0 : photo_->image.width() / double(photo_->image.height());
        photo_rect_ = QRectF(0.5 * (frame_.width_mm - aspect * height), 0.0, aspect * height, height);
        become(State::Problem);
        return;
    }
    // Places in the picture count from the centre of its first pixel.
    const Rect corners{built->photo_to_surface(Vec2(-0.5)),
                       built->photo_to_surface(Vec2(extraction.width - 0.5, extraction.height - 0.5))};
    photo_rect_ = frame_.from_surface(corners);
    list_faces(*built);
    servo_.place(Vec2(0.0));
    servo_.engage();
    hand_.reset();
    become(State::Ready);
    timer_.start();
}

void ExploreSession::list_faces(const BuiltScene& built) {
    const std::vector<Face>& faces = photo_->extraction.faces;
    std::size_t contour = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        QVariantList features;
        if (!chosen_face_ || *chosen_face_ == i)
            for (std::size_t k = 0; k < faces[i].contours.size(); ++k, ++contour) {
                const int index = static_cast<int>(contour);
                features << QVariantMap{
                    {"index", index},
                    {"name", name_of(index)},
                    {"rect", frame_.from_surface(bounds_of(servo_.felt().lines[contour].points))}};
            }
        const Rect box{built.photo_to_surface(faces[i].box.min), built.photo_to_surface(faces[i].box.max)};
        faces_ << QVariantMap{{"name", faces.size() == 1 ? QString("face") : QString("face %1").arg(i + 1)},
                              {"rect", frame_.from_surface(box)},
                              {"chosen", chosen_face_ == i},
                              {"features", features}};
    }
}

void ExploreSession::chooseFace(int index) {
    if (state_ != State::Ready || index >= faceCount())
        return;
    stop_everything();
    chosen_face_ = index < 0 ? std::optional<std::size_t>{} : static_cast<std::size_t>(index);
    build();
    if (index < 0)
        tell(faceCount() == 1 ? QString("The face.") : QString("All %1 faces.").arg(faceCount()),
             Priority::touch);
    else
        tell(faceCount() == 1 ? QString("The face.") : QString("Face %1 alone.").arg(index + 1),
             Priority::touch);
}

void ExploreSession::nextFace() {
    const int next = chosen_face_ ? static_cast<int>(*chosen_face_) + 1 : 0;
    chooseFace(next < faceCount() ? next : -1);
}

// --- the hand ---

void ExploreSession::touchDown(double x, double y) {
    if (state_ != State::Ready || touring())
        return;
    hand_ = frame_.to_surface({x, y});
    servo_.place(*hand_);
}

void ExploreSession::moveTo(double x, double y) {
    const Vec2 to = frame_.to_surface({x, y});
    if (state_ != State::Ready || hand_ == to)
        return;
    hand_ = to;
    if (!touring() || grabs(to))
        servo_.move(to);
}

bool ExploreSession::grabs(Vec2 to) {
    if (!grab_from_)
        grab_from_ = to;
    if (length(to - *grab_from_) <= grab_mm)
        return false;
    end_tour("Tour ended.");
    return true;
}

void ExploreSession::nudge(double dx, double dy) {
    if (state_ != State::Ready)
        return;
    if (touring())
        end_tour("Tour ended.");
    servo_.move(servo_.pointer() + Vec2(dx, -dy));
}

// --- features ---

bool ExploreSession::stepFeature(int step) {
    if (state_ != State::Ready)
        return false;
    const int next = last_feature_ < 0 ? (step > 0 ? 0 : featureCount() - 1) : last_feature_ + step;
    if (next < 0 || next >= featureCount()) {
        last_feature_ = -1;
        return false;
    }
    goToFeature(next);
    return true;
}

void ExploreSession::goToFeature(int index) {
    if (state_ != State::Ready || index < 0 || index >= featureCount())
        return;
    if (touring())
        servo_.let_go();
    servo_.place(landing_place(servo_.felt().lines[static_cast<std::size_t>(index)]));
    set_feature(index);
    emit modeChanged();
    tell(name_of(index), Priority::touch);
}

void ExploreSession::set_feature(int index) {
    if (index >= 0)
        last_feature_ = index;
    if (tracker_.current() == index && index >= 0)
        return;
    tracker_.set(index);
    emit featureChanged();
}

void ExploreSession::whereAmI() {
    if (state_ != State::Ready)
        tell(sentence_.isEmpty() ? QString("There is no photograph yet. Press O to open one.") : sentence_,
             Priority::touch);
    else
        tell(where_am_i(servo_.felt(), servo_.finger(), tracker_.current()), Priority::touch);
}

// --- tour and force ---

int ExploreSession::tour_feature() const {
    if (tracker_.current() >= 0)
        return tracker_.current();
    if (last_feature_ >= 0)
        return last_feature_;
    const std::vector<Polyline>& lines = servo_.felt().lines;
    const Vec2 finger = servo_.finger();
    const auto nearest =
        std::min_element(lines.begin(), lines.end(), [&](const Polyline& a, const Polyline& b) {
            return distance_to(a, finger) < distance_to(b, finger);
        });
    return static_cast<int>(nearest - lines.begin());
}

void ExploreSession::toggleTour() {
    if (state_ != State::Ready)
        return whereAmI();
    if (touring())
        return end_tour("Tour ended.");
    if (!engaged())
        return tell(force_is_off, Priority::touch);
    const int index = tour_feature();
    grab_from_ = hand_;
    servo_.lead_along(static_cast<std::size_t>(index));
    last_feature_ = index;
    emit modeChanged();
    tell("Tour round the " + name_of(index) + ".", Priority::touch);
}

void ExploreSession::end_tour(const QString& sentence) {
    servo_.let_go();
    tour_progress_ = 0.0;
    grab_from_.reset();
    emit modeChanged();
    tell(sentence, Priority::message);
}

void ExploreSession::stop_everything() {
    servo_.disengage();
    servo_.let_go();
    tour_progress_ = 0.0;
    narrator_.stop();
    emit modeChanged();
}

/// Back to what was open before.
void ExploreSession::stop_looking() {
    loader_.cancel();
    if (!photo_) {
        become(State::Empty);
        return tell("Stopped looking. Press O to open a photograph.", Priority::touch);
    }
    build();
    stop_everything();
    tell("Stopped looking. " + photo_->name + " is open again. " +
             (state_ == State::Ready ? force_is_off : ""),
         Priority::touch);
}

void ExploreSession::stopOrStart() {
    if (state_ == State::Looking)
        return stop_looking();
    if (state_ != State::Ready) {
        narrator_.stop();
        return;
    }
    if (!engaged())
        return engage();
    stop_everything();
    tell("Stopped. " + force_is_off, Priority::touch);
}

void ExploreSession::engage() {
    if (state_ != State::Ready)
        return;
    servo_.engage();
    emit modeChanged();
    tell("The force is on.", Priority::touch);
}

void ExploreSession::setMaxForce(double newtons) {
    max_force_ = std::clamp(newtons, 0.0, settings_.servo.limits.max_force);
    servo_.set_max_force(max_force_);
    emit modeChanged();
}

// --- what the servo says ---

void ExploreSession::poll() {
    const ServoSnapshot now = servo_.snapshot();
    const Vec2 finger_mm = servo_.finger();
    const QPointF finger = frame_.from_surface(finger_mm);
    const QPointF force(now.fx, -now.fy);
    const QPointF pointer = touring() ? finger : frame_.from_surface(servo_.pointer());
    const double progress = touring() ? now.tour_progress : 0.0;
    if (finger != finger_ || force != force_ || pointer != pointer_ || progress != tour_progress_) {
        finger_ = finger;
        force_ = force;
        pointer_ = pointer;
        tour_progress_ = progress;
        emit handMoved();
    }
    watch_faults(now.fault);
    if (servo_.has_led())
        end_tour("Tour finished.");
    follow_finger(finger_mm);
}

void ExploreSession::follow_finger(Vec2 finger) {
    const int before = tracker_.current();
    const int feature = tracker_.follow(servo_.felt(), finger);
    if (feature == before)
        return;
    if (feature >= 0)
        last_feature_ = feature;
    emit featureChanged();
    if (feature >= 0 && !touring())
        narrator_.tell(name_of(feature), Priority::touch);
}

void ExploreSession::watch_faults(Fault fault) {
    const Fault shown = faults_.shown();
    const bool must_tell = faults_.must_tell(fault, 1e-3 * static_cast<double>(clock_.elapsed()));
    if (disables(fault) && engaged())
        stop_everything();
    if (must_tell)
        tell(faultSentence(), Priority::fault);
    if (faults_.shown() != shown)
        emit modeChanged();
}

} // namespace tp
