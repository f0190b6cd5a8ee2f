// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/touch_gestures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {
namespace {

constexpr double level = 1.5; ///< a swipe goes at least so much farther across than up or down

} // namespace

void TouchGestures::press(int finger, Vec2 place, double now) {
    if (down_.empty()) {
        most_ = 0;
        moved_ = false;
        ways_.clear();
        first_ = place;
        begin_ = now;
    }
    down_[finger] = {place, place, place};
    for (auto& [other, of] : down_)
        of.from = of.at;
    most_ = std::max(most_, down_.size());
}

void TouchGestures::move(int finger, Vec2 place) {
    const auto found = down_.find(finger);
    if (found == down_.end())
        return;
    found->second.at = place;
    moved_ = moved_ || length(place - found->second.down) > tap_mm;
}

TouchGestures::Gesture TouchGestures::release(int finger, double now) {
    const auto found = down_.find(finger);
    if (found == down_.end())
        return Gesture::none;
    ways_.push_back(found->second.at - found->second.from);
    down_.erase(found);
    return down_.empty() ? meaning(now) : Gesture::none;
}

TouchGestures::Gesture TouchGestures::meaning(double now) {
    const std::optional<Tap> before = std::exchange(before_, std::nullopt);
    if (moved_)
        return most_ == 2 ? swipe() : Gesture::none;
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

TouchGestures::Gesture TouchGestures::swipe() const {
    const auto go = [this](double sign) {
        return std::ranges::all_of(ways_, [sign](Vec2 way) {
            return sign * way.x >= swipe_mm && std::abs(way.x) >= level * std::abs(way.y);
        });
    };
    return go(1.0)    ? Gesture::two_finger_swipe_right
           : go(-1.0) ? Gesture::two_finger_swipe_left
                      : Gesture::none;
}

void TouchGestures::cancel() {
    down_.clear();
    most_ = 0;
    before_.reset();
}

} // namespace tp
