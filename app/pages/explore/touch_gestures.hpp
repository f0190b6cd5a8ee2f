// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <map>
#include <optional>
#include <vector>

namespace tp {

/// Tells what fingers on the surface mean. One finger explores from its first moment; taps and swipes are told when the
/// last finger is lifted, so that one that was not meant can still be dragged elsewhere. How long several fingers rest
/// does not matter, only how they moved; two taps belong together if the second begins soon after the first.
///
/// Places are on the surface in mm, times in s.
class TouchGestures {
public:
    enum class Gesture {
        none,
        double_tap,
        double_tap_and_hold,
        two_finger_tap, ///< told at once; a double tap is told as one of these and then as itself
        two_finger_double_tap,
        three_finger_tap,
        two_finger_swipe_right, ///< both fingers went that way
        two_finger_swipe_left,
    };
    static constexpr double tap_mm = 10.0;   ///< a finger that moves farther does not tap
    static constexpr double swipe_mm =
        20.0; ///< both fingers of a swipe go that far, since the second one came
    static constexpr double tap_s = 0.5;     ///< one finger that stays longer explores or holds
    static constexpr double between_s = 0.6; ///< from one tap's end to the next one's beginning
    static constexpr double apart_mm = 15.0; ///< of two taps at one place

    void press(int finger, Vec2 place, double now);
    void move(int finger, Vec2 place);
    Gesture release(int finger, double now);
    /// The system has taken the touch away: nothing was meant.
    void cancel();
    /// One finger is down and it has been alone since it came.
    bool explores() const { return most_ == 1 && down_.size() == 1; }

private:
    struct Tap {
        int fingers = 0;
        Vec2 place{0.0};
        double end = 0.0;
    };
    struct Finger {
        Vec2 down{0.0}; ///< where it was set down
        Vec2 from{0.0}; ///< where it was when the last finger came
        Vec2 at{0.0};
    };
    Gesture meaning(double now);
    Gesture swipe() const;

    std::map<int, Finger> down_;
    std::vector<Vec2> ways_;   ///< of the fingers that were lifted, each since the last finger came
    std::size_t most_ = 0;     ///< fingers at once since the first one came
    bool moved_ = false;
    Vec2 first_{0.0};
    double begin_ = 0.0;
    std::optional<Tap> before_;
};

} // namespace tp
