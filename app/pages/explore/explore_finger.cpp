// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_finger.hpp"

#include "app/pages/explore/feature_labels.hpp"
#include "app/pages/explore/place_words.hpp"

#include <algorithm>

namespace tp {

namespace {
constexpr double handle_moved_mm = 0.3; ///< a device's finger that moves by more is not at rest
}

ExploreFinger::ExploreFinger(FingerServo& servo, ExploreView& view, ExploreWords& words, const PageClock& now,
                             double dwell_s)
    : servo_(servo), view_(view), words_(words), now_(now), dwell_s_(dwell_s), dwell_(dwell_s) {
    pointer_ = place_ = view_.frame().from_surface(Vec2(0.0));
    connect(&view_, &ExploreView::replaced, this, &ExploreFinger::begin_anew);
}

/// What is felt is another.
void ExploreFinger::begin_anew() {
    set_feature(-1);
    last_feature_ = -1;
    hand_place_.reset();
    force_ = {};
    emit moved();
}

Vec2 ExploreFinger::felt_place() const {
    const bool fingertip = hand_.is_fingertip() && !servo_.real() && !servo_.leads();
    return fingertip ? servo_.pointer() : servo_.finger();
}

void ExploreFinger::set_down(Vec2 place) {
    stir();
    servo_.place(place);
}

void ExploreFinger::draw_to(Vec2 place) {
    stir();
    servo_.move(place);
}

void ExploreFinger::poll(const ServoSnapshot& seen, double now) {
    const SheetFrame& frame = view_.frame();
    const QPointF place = frame.from_surface(servo_.finger());
    const QPointF force(seen.fx, -seen.fy);
    const QPointF pointer = servo_.leads() ? place : frame.from_surface(servo_.pointer());
    const bool led = servo_.by_touch() && servo_.leads();
    const QPointF leader = led ? frame.from_surface(servo_.leader()) : place;
    if (place != place_ || force != force_ || pointer != pointer_ || leader != leader_ || led != led_) {
        led_ = led;
        leader_ = leader;
        place_ = place;
        force_ = force;
        pointer_ = pointer;
        emit moved();
    }
    if (servo_.real() && length(servo_.finger() - handle_was_at_) > handle_moved_mm) {
        handle_was_at_ = servo_.finger();
        moved_at_ = now;
    }
}

int ExploreFinger::follow() {
    const int before = tracker_.current();
    const int feature = tracker_.follow(view_.felt(), felt_place());
    if (feature != before) {
        if (feature >= 0)
            last_feature_ = feature;
        emit featureChanged();
    }
    return feature;
}

void ExploreFinger::set_feature(int index) {
    if (index >= 0)
        last_feature_ = index;
    dwell_.settle(index);
    if (tracker_.current() == index && index >= 0)
        return;
    tracker_.set(index);
    emit featureChanged();
}

int ExploreFinger::meant_feature() const {
    if (feature() >= 0)
        return feature();
    if (last_feature_ >= 0)
        return last_feature_;
    return std::max(0, view_.nearest(felt_place()).contour);
}

void ExploreFinger::whereAmI() {
    if (!view_.ready()) {
        words_.tell(view_.where_one_is(), Priority::touch);
        return;
    }
    const Vec2 place = felt_place();
    const Guidance guidance = view_.nearest(place);
    if (guidance.contour < 0) {
        words_.tell(tr("There is nothing to feel here."), Priority::touch);
        return;
    }
    const SceneFeature& nearest = view_.feature(guidance.contour);
    const Rect box = bounds_of(view_.line(guidance.contour).points);
    Whereabouts where;
    where.person = view_.name_of_face(nearest.face);
    where.beside = !view_.face_places()[nearest.face].contains(place);
    where.feature = feature_word(nearest.name);
    where.on_it = guidance.distance <= FeatureTracker::enter_mm;
    const Vec2 way = where.on_it ? place - box.centre() : guidance.nearest - place;
    where.hour = clock_direction(way);
    where.millimetres = static_cast<int>(std::lround(length(way)));
    words_.tell(where_am_i(where), Priority::touch);
}

} // namespace tp
