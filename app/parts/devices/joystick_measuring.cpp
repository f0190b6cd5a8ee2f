// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/joystick_measuring.hpp"

#include "core/guidance/haptic_scene.hpp"

#include <utility>

namespace tp {

namespace {

constexpr double draw_out_mm = 6.0; ///< twice a movement
constexpr double hold_mm =
    20.0; ///< a far line: a hand that gives way by 1 mm changes the force by a twentieth
constexpr double drift_mm = 1.0;     ///< after which the line is drawn anew
constexpr double force_gone_s = 0.1; ///< longer than the chain's ramps

} // namespace

std::unique_ptr<HapticScene> line_that_pulls(Vec2 finger, Vec2 toward, double newtons, double reach_mm) {
    constexpr double long_mm = 200.0;
    const Vec2 middle = finger + reach_mm * toward;
    const Vec2 along(-toward.y, toward.x);
    const Scene line{2.0 * long_mm,
                     2.0 * long_mm,
                     {contour_through("line", {middle - long_mm * along, middle + long_mm * along}, false)}};
    Result<std::unique_ptr<HapticScene>> made = make_haptic_scene(line, {newtons / reach_mm, reach_mm});
    return made ? std::move(*made) : nullptr;
}

void JoystickMeasuring::want(double now) {
    loop_.disengage();
    drawn_at_.reset();
    pulls_at_ = trial_.pull() == Vec2(0.0) ? std::nullopt : std::optional(now + force_gone_s);
}

void JoystickMeasuring::draw(Vec2 finger) {
    const bool weighing = trial_.step() == JoystickTrial::Step::weigh;
    loop_.render(
        line_that_pulls(finger, trial_.pull(), JoystickTrial::pull_n, weighing ? hold_mm : draw_out_mm));
    drawn_at_ = finger;
}

bool JoystickMeasuring::poll(double now) {
    const ServoSnapshot seen = loop_.snapshot();
    if (seen.ticks == 0)
        return false;
    const JoystickTrial::Step before = trial_.step();
    if (!pulls_at_ && trial_.sample(seen.finger(), now))
        want(now);
    if (pulls_at_ && now >= *pulls_at_) {
        pulls_at_.reset();
        device_.assume(trial_.assumed().newtons_at_full, trial_.assumed().sign);
        draw(seen.finger());
        loop_.engage();
    } else if (trial_.step() == JoystickTrial::Step::weigh && drawn_at_ &&
               length(seen.finger() - *drawn_at_) > drift_mm) {
        draw(seen.finger());
    }
    return trial_.step() != before;
}

Result<bool> JoystickMeasuring::weighed(double grams, double now) {
    const double asked = pulls_at_ ? 0.0 : dot(loop_.snapshot().force(), trial_.pull());
    Result<bool> done = trial_.weighed(grams, asked);
    if (done)
        want(now);
    return done;
}

QString JoystickMeasuring::words() const {
    switch (trial_.step()) {
    case JoystickTrial::Step::right:
    case JoystickTrial::Step::away:
        return tr("The stick will move by itself, a little to the right and back, then a little away from "
                  "you and back. Let it "
                  "stand free, and keep your hands off it.");
    case JoystickTrial::Step::weigh:
        return tr("Now it is clear which way the stick pulls. Hold its grip with a kitchen scale or a "
                  "luggage scale, straight towards you: the stick pulls away from you. When the grip stands "
                  "still, enter how many grams the scale shows.");
    case JoystickTrial::Step::measured:
        return tr("The stick is measured.");
    case JoystickTrial::Step::failed:
        break;
    }
    switch (trial_.failure()) {
    case JoystickTrial::Failure::not_still:
        return tr(
            "The stick did not stand still. Let go of it, check that nothing touches it, and measure again.");
    case JoystickTrial::Failure::not_moved:
        return tr("The stick did not move. Check that its power supply is plugged in, keep your hands off "
                  "it, and measure again.");
    case JoystickTrial::Failure::other_axis:
        return tr("The stick moved to one side of where it should have gone. It cannot be measured like "
                  "that: check that nothing touches it and that it stands straight, and measure again.");
    case JoystickTrial::Failure::changes_mind:
        return tr(
            "The stick did not come back the way it went. Check that nothing touches it, and measure again.");
    case JoystickTrial::Failure::not_weighed:
        return tr("The stick was not weighed for three minutes, and its force is off. Measure it again when "
                  "a scale is at hand.");
    case JoystickTrial::Failure::none:
        break;
    }
    return {};
}

} // namespace tp
