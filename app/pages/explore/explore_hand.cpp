// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_hand.hpp"

#include "app/pages/explore/feature_labels.hpp"
#include "app/pages/explore/place_words.hpp"

#include <QPointF>

#include <cmath>

namespace tp {

ExploreHand::ExploreHand(FingerServo& servo, ExploreView& view, ExploreFinger& finger, ExploreTour& tour,
                         ExploreEar& ear, ExploreWords& words, const PageClock& now)
    : servo_(servo), view_(view), finger_(finger), tour_(tour), ear_(ear), words_(words), now_(now) {}

// --- mouse and keys ---

void ExploreHand::touchDown(double x, double y) {
    if (!view_.ready() || (tour_.touring() && !servo_.by_touch()))
        return;
    finger_.hand().mouse();
    set_down({x, y});
}

void ExploreHand::set_down(QPointF place) {
    const Vec2 there = view_.frame().to_surface(place);
    finger_.hand_at(there);
    finger_.set_down(there);
}

void ExploreHand::moveTo(double x, double y) {
    const QPointF place(x, y);
    if (!view_.ready() || finger_.hand_place() == view_.frame().to_surface(place))
        return;
    finger_.hand().mouse();
    move_to(place);
}

void ExploreHand::move_to(QPointF place) {
    const Vec2 there = view_.frame().to_surface(place);
    finger_.hand_at(there);
    if (servo_.real()) // whose handle says where the finger is, on a tour too
        return;
    finger_.stir();
    if (tour_.yields_to(there))
        finger_.draw_to(there);
}

void ExploreHand::handGone() {
    if (servo_.real() || finger_.hand().touches())
        return;
    finger_.hand().mouse_gone();
    servo_.lift();
    finger_.forget_moves();
    ear_.lift();
}

void ExploreHand::nudge(double dx, double dy) {
    if (!view_.ready())
        return;
    if (tour_.touring() && !servo_.by_touch())
        tour_.end_told();
    if (servo_.real()) {
        words_.tell(tr("Move the finger with the device."), Priority::touch);
        return;
    }
    finger_.hand().keys();
    finger_.draw_to(servo_.pointer() + Vec2(dx, -dy));
}

// --- fingers on a touchscreen ---

void ExploreHand::fingerDown(int id, double x, double y) {
    gestures_.press(id, view_.frame().to_surface({x, y}), now_());
    if (!gestures_.explores()) {
        finger_.hand().several_fingers();
        servo_.lift();
        return ear_.silence();
    }
    finger_.hand().one_finger();
    ear_.listen();
    if (!view_.ready())
        return;
    if (!tour_.touring() || servo_.by_touch())
        set_down({x, y});
    ear_.hear();
}

void ExploreHand::fingerMoved(int id, double x, double y) {
    gestures_.move(id, view_.frame().to_surface({x, y}));
    if (!gestures_.explores() || !view_.ready())
        return;
    finger_.hand().one_finger();
    if (finger_.hand_place() != view_.frame().to_surface({x, y}))
        move_to({x, y});
    ear_.hear(); // at once: the next poll would be late by up to its interval
}

void ExploreHand::fingerUp(int id) {
    const TouchGestures::Gesture gesture = gestures_.release(id, now_());
    if (!gestures_.explores())
        lift();
    emit meant(gesture);
}

void ExploreHand::fingersCancelled() {
    gestures_.cancel();
    lift();
}

void ExploreHand::lift() {
    finger_.hand().lifted();
    servo_.lift();
    ear_.lift();
}

// --- from feature to feature ---

bool ExploreHand::stepFeature(int step) {
    if (!view_.ready())
        return false;
    const int last = finger_.last_feature();
    const int next = last < 0 ? (step > 0 ? 0 : view_.featureCount() - 1) : last + step;
    if (next < 0 || next >= view_.featureCount()) {
        finger_.set_last_feature(-1);
        return false;
    }
    goToFeature(next);
    return true;
}

void ExploreHand::goToFeature(int index) {
    if (!view_.ready() || index < 0 || index >= view_.featureCount())
        return;
    if (tour_.touring())
        tour_.end();
    if (servo_.real())
        return tell_way_to(index);
    finger_.hand().keys();
    finger_.set_down(landing_place(view_.line(index)));
    finger_.set_feature(index);
    words_.tell(view_.label_of(index), Priority::touch);
}

/// Nobody's finger is set down elsewhere.
void ExploreHand::tell_way_to(int feature) {
    finger_.set_last_feature(feature);
    const Polyline& line = view_.line(feature);
    const Vec2 here = finger_.felt_place();
    const Vec2 way = point_along(line, nearest_arc(line, here)) - here;
    words_.tell(tr("%1: %2 o'clock, %n millimetre(s).", nullptr, static_cast<int>(std::lround(length(way))))
                    .arg(at_the_start(view_.label_of(feature)))
                    .arg(clock_direction(way)),
                Priority::touch);
}

} // namespace tp
