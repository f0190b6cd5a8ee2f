// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/fault.hpp"
#include "core/servo/force_device.hpp"

#include <vector>

namespace tp {

/// Bounds on what a person may feel. The defaults are the product's (DESIGN.md §5).
struct SafetyLimits {
    double max_force = 1.5;        ///< N, the user's own limit; the device's limit is taken where it is lower
    double max_force_rate = 40.0;  ///< N/s; 0.8 N in 20 ms
    double max_speed = 1500.0;     ///< mm/s; a hand exploring a picture stays well below 500
    double stale_after = 0.020;    ///< s without a newer reading; how old one may be when it comes
    double ramp_down = 0.020;      ///< s from any force to zero on a fault
    double engage_ramp = 0.5;      ///< s from no force to the whole force
    double late_periods = 3.0;     ///< ticks late before the force is ramped down
    double stall = 0.050;          ///< s without a tick before the device is disabled
    double workspace_margin = 5.0; ///< mm outside the workspace that are still believed
};

/// What one tick hands to the chain.
struct SafetyInput {
    double now = 0.0;   ///< s
    bool fresh = false; ///< a reading arrived that is newer by the device's own stamp (FreshReadings)
    bool device_lost = false;
    bool halted = false;     ///< the watchdog has halted the device
    bool motors_off = false; ///< the device's own doing
    Vec2 position{0.0};      ///< mm, device frame, of the newest reading
    Vec2 velocity{0.0};      ///< mm/s, device frame, filtered
    Vec2 force{0.0};         ///< N, device frame, as the law wants it
};

/// The one place between any law and any device, and the only maker of a force that a device accepts.
///
/// In order: faults are noticed, what is not a number becomes zero, the gain ramps up after engaging and down
/// on a fault, the magnitude is clamped, its change limited. A fault of a moment heals when its cause is
/// gone: the gain ramps up again. A disabling fault stays until engage(). Not thread-safe; allocates nothing.
class SafetyChain {
public:
    /// `period` in s, of the loop.
    SafetyChain(const SafetyLimits& limits, const Capabilities& device, double period);

    /// Lets the force in, by a ramp; forgets a disabling fault.
    void engage(double now) noexcept;
    /// Another hand (the watchdog) has let only `share` of the last force through since: the chain goes on
    /// from there.
    void lowered_to(double share) noexcept;
    /// As before the first reading: without force, and nothing is awaited. A disabling fault stays until engage().
    void rest() noexcept;
    /// Takes the force away, by a ramp.
    void disengage() noexcept { engaged_ = false; }
    bool engaged() const noexcept { return engaged_; }

    SafeForce pass(const SafetyInput& input) noexcept;

    /// What is wrong now.
    Fault fault() const noexcept { return fault_; }
    /// Share of the wanted force that is let through, 0 … 1.
    double gain() const noexcept { return gain_; }
    void set_max_force(double newtons) noexcept;

private:
    Fault notice(const SafetyInput& input, double elapsed) noexcept;
    void move_gain(const SafetyInput& input, double elapsed) noexcept;
    bool inside_workspace(Vec2 position) const noexcept;

    SafetyLimits limits_;
    std::vector<Vec2> workspace_;
    double device_max_;
    double max_force_;
    double period_;
    double last_tick_ = 0.0;
    double last_fresh_ = 0.0;
    bool started_ = false;
    bool engaged_ = false;
    Fault fault_ = Fault::none;
    double gain_ = 0.0;
    Vec2 last_force_{0.0};
};

} // namespace tp
