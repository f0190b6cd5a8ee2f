// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_zoom.hpp"

#include "app/pages/explore/feature_labels.hpp"
#include "app/pages/explore/feature_tracker.hpp"
#include "app/pages/explore/passage_earcons.hpp"
#include "app/pages/explore/zoom_steps.hpp"
#include "core/guidance/tent_profile.hpp"

#include <cstddef>
#include <optional>

namespace tp {

ExploreZoom::ExploreZoom(FingerServo& servo, ExploreView& view, ExploreFinger& finger, ExploreTour& tour,
                         ExploreWords& words, const PageClock& now)
    : servo_(servo), view_(view), finger_(finger), tour_(tour), words_(words), now_(now) {
    connect(&view_, &ExploreView::sceneChanged, this, &ExploreZoom::changed);
}

QString ExploreZoom::sentence() const {
    const Subject& subject = view_.subject();
    if (subject == Subject{})
        return view_.faceCount() == 1 ? tr("Zoomed out to the whole face.")
                                      : tr("Zoomed out to all %n face(s).", nullptr, view_.faceCount());
    const bool named = view_.faceCount() > 1 || !view_.person_of(*subject.face).isEmpty();
    const QString person = view_.name_of_face(*subject.face);
    switch (subject.part) {
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

/// Whether there is something to zoom; where not, says what can be done.
bool ExploreZoom::ready() {
    if (!view_.ready())
        words_.tell(view_.where_one_is(), Priority::touch);
    return view_.ready();
}

void ExploreZoom::zoom_to(const Subject& subject) {
    if (tour_.touring())
        tour_.end();
    if (!view_.fit(subject))
        return words_.tellProblem(tr("This part is too small in the picture to zoom to it."));
    const int here = FeatureTracker().follow(view_.felt(), finger_.felt_place());
    finger_.set_feature(here); // told with the zoom, which it would cut short a moment later
    told_at_ =
        words_.tell(here < 0 ? sentence() : tr("%1 %2.").arg(sentence(), at_the_start(view_.label_of(here))),
                    Priority::touch);
    zoomed_at_ = now_();
    zoomed_from_ = servo_.finger();
}

bool ExploreZoom::tells(double now) const {
    const bool rests = servo_.real() ? length(servo_.finger() - zoomed_from_) <
                                           TentProfile{}.band() // as far as a force draws
                                     : finger_.moved_at() <= zoomed_at_;
    return now < told_at_ && rests;
}

void ExploreZoom::zoomIn() {
    if (!ready())
        return;
    const Vec2 place = finger_.felt_place();
    const int face = face_at(view_.face_places(), place);
    const int nearest = view_.nearest(place).contour;
    const std::size_t here = face >= 0      ? static_cast<std::size_t>(face)
                             : nearest >= 0 ? view_.feature(nearest).face
                                            : 0;
    zoom_to(zoomed_in(view_.extraction(), view_.subject(), here));
}

void ExploreZoom::zoomOut() {
    if (!ready())
        return;
    if (const std::optional<Subject> out = zoomed_out(view_.extraction(), view_.subject()))
        return zoom_to(*out);
    words_.tell(Earcon::list_end, tr("This is the whole picture."), Priority::touch);
}

void ExploreZoom::zoomHere(double x, double y) {
    if (!ready())
        return;
    constexpr double reach_mm = 8.0;
    const Vec2 place = view_.frame().to_surface({x, y});
    const int face = face_at(view_.face_places(), place);
    int feature = -1;
    for (int i = 0; i < view_.featureCount(); ++i) { // inside a ring one is at it, however far its line is
        const Rect box = bounds_of(view_.line(i).points);
        const Rect grown{box.min - Vec2(reach_mm), box.max + Vec2(reach_mm)};
        if (view_.feature(i).name != feature::outline && grown.contains(place) &&
            (feature < 0 || distance_to(view_.line(i), place) < distance_to(view_.line(feature), place)))
            feature = i;
    }
    if (face < 0 && feature < 0)
        return zoomOut();
    const SceneFeature there =
        feature >= 0 ? view_.feature(feature) : SceneFeature{static_cast<std::size_t>(face), {}};
    if (const std::optional<Subject> nearer = zoomed_to(view_.extraction(), view_.subject(), there))
        return zoom_to(*nearer);
    words_.tell(Earcon::list_end, tr("There is nothing more to zoom in to here."), Priority::touch);
}

void ExploreZoom::chooseFace(int index) {
    if (!view_.ready() || index >= view_.faceCount())
        return;
    zoom_to(index < 0 ? Subject{} : Subject{static_cast<std::size_t>(index), FacePart::whole});
}

void ExploreZoom::nextFace() {
    const std::optional<std::size_t>& face = view_.subject().face;
    const int next = face ? static_cast<int>(*face) + 1 : 0;
    chooseFace(next < view_.faceCount() ? next : -1);
}

} // namespace tp
