// SPDX-License-Identifier: Apache-2.0
#include "core/servo/safety_chain.hpp"

#include "core/geometry/polyline.hpp"

#include <algorithm>
#include <limits>

namespace tp {

namespace {

/// From one force towards another by at most so many newtons.
Vec2 moved(Vec2 from, Vec2 to, double newtons) {
    const double whole = length(to - from);
    return whole > newtons ? from + (newtons / whole) * (to - from) : to;
}

Vec2 clamped(Vec2 value, double largest) {
    const double size = length(value);
    return size > largest ? (largest / size) * value : value;
}

} // namespace

SafetyChain::SafetyChain(const SafetyLimits& limits, const Capabilities& device, double period)
    : limits_(limits), workspace_(device.workspace), device_max_(device.max_force), period_(period) {
    set_max_force(limits.max_force);
}

void SafetyChain::set_max_force(double newtons) noexcept {
    max_force_ = std::isfinite(newtons) ? std::clamp(newtons, 0.0, device_max_) : 0.0;
}

void SafetyChain::engage(double now) noexcept {
    engaged_ = true;
    fault_ = Fault::none;
    gain_ = 0.0;
    last_tick_ = now;
    last_fresh_ = now;
    started_ = true;
}

void SafetyChain::rest() noexcept {
    started_ = false;
    engaged_ = false;
    if (!disables(fault_))
        fault_ = Fault::none;
    gain_ = 0.0; // and so is the first force
    reading_seen_ = false;
}

void SafetyChain::lowered_to(double share) noexcept {
    gain_ *= share;
    last_force_ *= share;
    last_target_ *= share;
}

bool SafetyChain::inside_workspace(Vec2 p) const noexcept {
    const std::size_t count = workspace_.size();
    if (count < 3)
        return true;
    bool inside = false;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 a = workspace_[i];
        const Vec2 b = workspace_[(i + 1) % count];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
            inside = !inside;
        nearest = std::min(nearest, length(p - nearest_on_segment(a, b, p)));
    }
    return inside || nearest <= limits_.workspace_margin;
}

Fault SafetyChain::notice(const SafetyInput& input, double elapsed) noexcept {
    if (input.device_lost)
        return Fault::device_lost;
    if (input.halted || elapsed > limits_.stall)
        return Fault::stalled;
    if (elapsed > (1.0 + limits_.late_periods) * period_)
        return Fault::late_ticks;
    if (input.now - last_fresh_ > limits_.stale_after)
        return Fault::stale_input;
    if (input.motors_off)
        return Fault::motors_off;
    if (!is_finite(input.position) || !is_finite(input.velocity) || !is_finite(input.force))
        return Fault::not_a_number;
    if (length(input.velocity) > limits_.max_speed)
        return Fault::over_speed;
    if (!inside_workspace(input.position))
        return Fault::outside_workspace;
    return Fault::none;
}

void SafetyChain::move_gain(const SafetyInput& input, double elapsed) noexcept {
    const bool let_in = engaged_ && reading_seen_ && fault_ == Fault::none;
    if (let_in)
        gain_ = std::min(1.0, gain_ + elapsed / limits_.engage_ramp);
    else
        gain_ = std::max(0.0, gain_ - elapsed / limits_.ramp_down);
    if (gain_ < 1e-9) // what rounding leaves of a ramp that has ended
        gain_ = 0.0;
    // A law that gives no number, a loop that stood still and a device that is gone leave nothing to ramp.
    if (disables(fault_) || !is_finite(input.force) || !is_finite(input.position))
        gain_ = 0.0;
}

/// How far the motion since the last reading accounts for a change of the force, N.
double SafetyChain::explained(const SafetyInput& input) noexcept {
    if (!input.fresh || !is_finite(input.position))
        return 0.0;
    const double elapsed = input.now - position_time_;
    if (reading_seen_ && elapsed == 0.0)
        return 0.0;
    // After a silence the place jumps, whatever the finger did meanwhile.
    const bool known =
        reading_seen_ && elapsed > 0.0 && elapsed <= (1.0 + limits_.late_periods) * period_ + 1e-9;
    const Vec2 step = known ? input.position - last_position_ : Vec2(0.0);
    last_position_ = input.position;
    position_time_ = input.now;
    reading_seen_ = true;
    if (!known) {
        motion_ = Vec2(0.0);
        return 0.0;
    }
    // A gap between readings is no time for a garbled one to become likely: it counts for two periods at the most.
    const double sudden = 1e3 * limits_.max_acceleration * std::min(elapsed, period_);
    motion_ = clamped(moved(motion_, step / elapsed, sudden), limits_.max_speed);
    const double stiffness = input.stiffness > 0.0 ? std::min(input.stiffness, limits_.max_stiffness) : 0.0;
    return stiffness * std::min(length(step), std::min(elapsed, 2.0 * period_) * length(motion_));
}

SafeForce SafetyChain::pass(const SafetyInput& input) noexcept {
    if (!started_) {
        started_ = true;
        last_tick_ = input.now;
        last_fresh_ = input.now;
    }
    const double elapsed = std::max(0.0, input.now - last_tick_);
    last_tick_ = input.now;
    if (input.fresh)
        last_fresh_ = input.now;

    if (!disables(fault_)) {
        const Fault noticed = notice(input, elapsed);
        const bool ramp_has_ended = gain_ == 0.0;
        if (noticed != Fault::none || ramp_has_ended)
            fault_ = noticed;
    }
    if (disables(fault_))
        engaged_ = false;
    const double by_motion = explained(input);
    move_gain(input, elapsed);

    const Vec2 target = gain_ > 0.0 ? clamped(gain_ * input.force, max_force_) : Vec2(0.0);
    const double allowed = limits_.max_force_rate * std::min(elapsed, period_ * limits_.late_periods);
    // On a fault the force must be gone in time, so that the last one may lose any share of itself there, and
    // only the way up and changes of direction are limited.
    const bool may_drop = fault_ != Fault::none || !engaged_;
    const Vec2 dropped = moved(nearest_on_segment(Vec2(0.0), last_force_, target), target, allowed);
    Vec2 force;
    if (may_drop)
        force = length(dropped) <= length(last_force_) ? dropped : moved(last_force_, target, allowed);
    else
        force = moved(last_force_ + clamped(target - last_target_, gain_ * by_motion), target, allowed);
    force = clamped(force, max_force_);
    if (gain_ == 0.0)
        force = Vec2(0.0);
    last_force_ = force;
    last_target_ = target;
    return SafeForce(force, gain_);
}

} // namespace tp
