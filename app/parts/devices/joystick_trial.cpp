// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/joystick_trial.hpp"

#include "device/hid_pid/joystick_scale_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tp {

namespace {

/// N of the whole force that a stick is taken for, one after the other: the less, the more of it is used.
constexpr std::array strengths{60.0, 30.0, 15.0, 8.0, 4.0};
constexpr double along_to_across = 2.0; ///< of a movement that is along an axis, at least
constexpr double least_strength = 2.0;  ///< N: half of the whole force is the most that is weighed

} // namespace

void JoystickTrial::rest() {
    pull_ = Vec2(0.0);
    since_.reset();
    resting_since_.reset();
}

bool JoystickTrial::fail(Failure why) {
    pull_ = Vec2(0.0);
    step_ = Step::failed;
    failure_ = why;
    return true;
}

bool JoystickTrial::sample(Vec2 place, double now) {
    if (step_ == Step::measured || step_ == Step::failed)
        return false;
    if (step_ == Step::weigh) {
        if (!since_)
            since_ = now;
        return now - *since_ > weigh_s && fail(Failure::not_weighed);
    }
    if (pull_ == Vec2(0.0)) {
        if (!resting_since_)
            resting_since_ = now;
        if (!since_ || length(place - from_) > still_mm) {
            from_ = place;
            since_ = now;
            return now - *resting_since_ > restless_s && fail(Failure::not_still);
        }
        if (now - *since_ < still_s)
            return false;
        pull_ = back_ ? -axis() : axis();
        from_ = place;
        since_ = now;
        return true;
    }
    const Vec2 by = place - from_;
    if (length(by) >= moved_mm)
        return moved(by);
    return now - *since_ > patience_s && pull_more_strongly();
}

bool JoystickTrial::moved(Vec2 by) {
    const double along = dot(by, pull_);
    const double across = std::abs(by.x * pull_.y - by.y * pull_.x);
    if (std::abs(along) < along_to_across * across)
        return fail(Failure::other_axis);
    rest();
    if (back_) {
        if (along < 0.0)
            return fail(Failure::changes_mind);
        back_ = false;
        step_ = step_ == Step::right ? Step::away : Step::weigh;
        if (step_ == Step::weigh)
            pull_ = Vec2(0.0, 1.0);
        return true;
    }
    double& sign = step_ == Step::right ? assumed_.sign.x : assumed_.sign.y;
    if (along < 0.0)
        sign = -sign;
    back_ = true;
    return true;
}

bool JoystickTrial::pull_more_strongly() {
    if (strength_ + 1 >= strengths.size())
        return fail(Failure::not_moved);
    assumed_.newtons_at_full = strengths[++strength_];
    rest();
    return true;
}

Result<bool> JoystickTrial::weighed(double grams, double asked_n) {
    if (!(grams >= 0.0 && grams < 1e5))
        return Error{"What the scale shows must be a number of grams from 0 to 100000."};
    if (!(asked_n > 0.1))
        return Error{"The stick does not pull now. Hold the grip where it is, and weigh again."};
    if (grams < least_grams && assumed_.newtons_at_full > least_strength) {
        assumed_.newtons_at_full = std::max(least_strength, 0.5 * assumed_.newtons_at_full);
        since_.reset();
        return false;
    }
    const double full = assumed_.newtons_at_full * 1e-3 * grams * standard_gravity / asked_n;
    if (full < least_joystick_newtons || full > greatest_joystick_newtons)
        return Error{"A stick cannot be as strong or as weak as that. Check that the scale shows grams and "
                     "pulls straight towards you, and weigh again."};
    assumed_.newtons_at_full = full;
    assumed_.measured = true;
    pull_ = Vec2(0.0);
    step_ = Step::measured;
    return true;
}

} // namespace tp
