// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_gestures.hpp"

namespace tp {

ExploreGestures::ExploreGestures(ExploreView& view, ExploreWalk& walk, ExploreFinger& finger,
                                 ExploreTour& tour, ExploreZoom& zoom, ExploreDevice& device)
    : view_(view), walk_(walk), finger_(finger), tour_(tour), zoom_(zoom), device_(device) {}

void ExploreGestures::perform(TouchGestures::Gesture gesture) {
    using enum TouchGestures::Gesture;
    switch (gesture) {
    case none:
        return;
    case double_tap:
    case three_finger_tap:
        return finger_.whereAmI();
    case double_tap_and_hold: {
        const QPointF place = view_.frame().from_surface(finger_.felt_place());
        return zoom_.zoomHere(place.x(), place.y());
    }
    case two_finger_tap:
        toured_before_tap_ = tour_.touring();
        emit stop_or_start_asked();
        return;
    case two_finger_double_tap: // its first tap has stopped or started the force already
        if (toured_before_tap_)
            return;
        if (!device_.engaged())
            device_.engage();
        return tour_.toggle();
    case two_finger_swipe_right: // as in Browse, where one finger to the right is the next photograph
        return walk_.next();
    case two_finger_swipe_left:
        return walk_.previous();
    }
}

} // namespace tp
