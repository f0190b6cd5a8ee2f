// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/touch_gestures.hpp"

#include <algorithm>
#include <utility>

namespace tp {

void TouchGestures::press(int finger, Vec2 place, double now) {
    if (down_.empty()) {
        most_ = 0;
        moved_ = false;
        first_ = place;
        begin_ = now;
    }
    down_[finger] = place;
    most_ = std::max(most_, down_.size());
}

void TouchGestures::move(int finger, Vec2 place) {
    const auto found = down_.find(finger);
    moved_ = moved_ || (found != down_.end() && length(place - found->second) > tap_mm);
}

TouchGestures::Gesture TouchGestures::release(int finger, double now) {
    if (down_.erase(finger) == 0 || !down_.empty())
        return Gesture::none;
    return meaning(now);
}

TouchGestures::Gesture TouchGestures::meaning(double now) {
    const std::optional<Tap> before = std::exchange(before_, std::nullopt);
    if (moved_)
        return Gesture::none;
    const auto fingers = static_cast<int>(most_);
    const bool second = before && before->fingers == fingers && begin_ - before->end <= between_s &&
                        length(first_ - before->place) <= apart_mm;
    const bool held = now - begin_ > tap_s;
    if (!second && (fingers == 2 || (fingers == 1 && !held)))
        before_ = Tap{fingers, first_, now};
    if (fingers >= 3)
        return Gesture::three_finger_tap;
    if (fingers == 2)
        return second ? Gesture::two_finger_double_tap : Gesture::two_finger_tap;
    if (!second)
        return Gesture::none;
    return held ? Gesture::double_tap_and_hold : Gesture::double_tap;
}

void TouchGestures::cancel() {
    down_.clear();
    most_ = 0;
    before_.reset();
}

} // namespace tp
