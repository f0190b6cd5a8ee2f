// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_view.hpp"

#include "app/pages/explore/extraction_words.hpp"
#include "app/pages/explore/feature_labels.hpp"
#include "app/photo/scene/extra_features.hpp"
#include "core/guidance/exact_law.hpp"
#include "core/guidance/tent_profile.hpp"

#include <QVariantMap>

#include <algorithm>
#include <utility>

namespace tp {

namespace {

Rect around(const Rect& a, const Rect& b) { return {glm::min(a.min, b.min), glm::max(a.max, b.max)}; }

std::size_t contour_count(const Extraction& extraction) {
    std::size_t contours = 0;
    for (const Face& face : extraction.faces)
        contours += face.contours.size();
    return contours;
}

} // namespace

ExploreView::ExploreView(const ExploreSettings& settings, FingerServo& servo, ExploreWords& words,
                         ExploreChoices& choices)
    : servo_(servo), words_(words), choices_(choices),
      surface_(settings.surface), frame_{surface_.width_mm, surface_.height_mm} {
    connect(&loader_, &PhotoLoader::loaded, this, [this](const std::shared_ptr<const LoadedPhoto>& photo) {
        looking_into_ ? emit looked_into(photo) : show(photo);
    });
    connect(&choices_, &ExploreChoices::changed, this, &ExploreView::take_extras);
}

// --- names ---

QString ExploreView::person_of(std::size_t face) const {
    return photo_ && face < photo_->names.size() ? photo_->names[face] : QString();
}

QString ExploreView::name_of_face(std::size_t face) const {
    const QString person = person_of(face);
    if (!person.isEmpty())
        return person;
    return faceCount() == 1 ? tr("the face") : tr("face %1").arg(face + 1);
}

QString ExploreView::label_of(int feature) const {
    if (feature < 0 || feature >= static_cast<int>(features_.size()))
        return {};
    const SceneFeature& one = features_[static_cast<std::size_t>(feature)];
    const bool several = !subject_.face && faceCount() > 1;
    return feature_label(one.name, person_of(one.face), several ? static_cast<int>(one.face) + 1 : 0);
}

QString ExploreView::title() const {
    QStringList people;
    if (photo_)
        people = QStringList(photo_->names.begin(), photo_->names.end());
    people.removeAll(QString());
    return people.isEmpty() ? photoName() : listed(people);
}

QString ExploreView::where_one_is() const {
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

// --- the photograph ---

void ExploreView::become(State state) {
    state_ = state;
    emit replaced();
    emit photoChanged();
    emit sceneChanged();
}

void ExploreView::forget_scene() {
    law_.reset();
    faces_.clear();
    features_.clear();
    face_places_.clear();
}

void ExploreView::begin_to_look() {
    emit replacing();
    servo_.clear();
    subject_ = {};
    forget_scene();
    become(State::Looking);
    words_.tell(tr("Looking for faces…"), Priority::message);
}

void ExploreView::load(const QString& file) {
    looking_into_ = false;
    begin_to_look();
    loader_.load(file);
}

void ExploreView::look_into(const QString& file) {
    if (!std::exchange(looking_into_, true))
        begin_to_look();
    loader_.load(file);
}

std::shared_ptr<const LoadedPhoto> ExploreView::with_wanted_extras(const LoadedPhoto& photo) const {
    auto with = std::make_shared<LoadedPhoto>(photo);
    with->extraction = with_extras(std::move(with->extraction), choices_.extras());
    return with;
}

bool ExploreView::can_be_felt(const LoadedPhoto& photo) const {
    return build_scene(with_wanted_extras(photo)->extraction, surface_, Subject{}).ok();
}

void ExploreView::show(std::shared_ptr<const LoadedPhoto> photo, const QString& before) {
    looking_into_ = false;
    loaded_ = std::move(photo);
    photo_ = with_wanted_extras(*loaded_);
    subject_ = {};
    build(true);
    found_ = describe(photo_->extraction, photo_->names);
    if (photo_->image.isNull() && !photo_->name.isEmpty())
        found_ = tr("%1: %2").arg(photo_->name, found_);
    const QString told = before.isEmpty() ? found_ : before + ' ' + found_;
    if (ready())
        words_.tell(Earcon::ready, told, Priority::message);
    else
        words_.tell(told, Priority::message);
}

void ExploreView::turn_back() {
    looking_into_ = false;
    loader_.cancel();
    if (photo_)
        build(true);
    else
        become(State::Empty);
}

QString ExploreView::give_up() {
    turn_back();
    if (!photo_)
        return tr("Search stopped. Press O to open a photograph.");
    return ready() ? tr("Search stopped. %1 is open again. The force is off. Press Enter to switch it on.")
                         .arg(photo_->name)
                   : tr("Search stopped. %1 is open again.").arg(photo_->name);
}

/// The person wants more or fewer features than are felt.
void ExploreView::take_extras() {
    if (!ready() || !loaded_)
        return;
    std::shared_ptr<const LoadedPhoto> wanted = with_wanted_extras(*loaded_);
    if (contour_count(wanted->extraction) == contour_count(photo_->extraction))
        return;
    photo_ = std::move(wanted);
    build(false);
}

// --- the scene ---

bool ExploreView::fit(const Subject& subject) {
    if (!build_scene(photo_->extraction, surface_, subject).ok())
        return false;
    subject_ = subject;
    build(false);
    return true;
}

void ExploreView::reach(std::vector<Vec2> reach) {
    if (reach == surface_.reach)
        return;
    surface_.reach = std::move(reach);
    if (ready())
        build(false);
}

/// From the photograph and the subject to what is felt. `anew`: as if nothing had been felt before.
void ExploreView::build(bool anew) {
    emit replacing();
    forget_scene();
    const Extraction& extraction = photo_->extraction;
    const Result<BuiltScene> built = build_scene(extraction, surface_, subject_);
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
    servo_.place(anew ? Vec2(0.0) : servo_.pointer());
    become(State::Ready);
    if (anew)
        emit fresh();
}

void ExploreView::list_faces() {
    faces_.clear();
    face_places_.clear();
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
        face_places_.push_back(whole);
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

void ExploreView::retranslate() {
    if (ready())
        list_faces();
    emit sceneChanged();
}

} // namespace tp
