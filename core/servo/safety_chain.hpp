// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/fault.hpp"
#include "core/servo/force_device.hpp"

#include <vector>

namespace tp {

/// Bounds on what a person may feel. The defaults are the product's (DESIGN.md §5).
struct SafetyLimits {
    double max_force = 1.5;        ///< N, the user's own limit; the device's limit is taken where it is lower
    double max_force_rate = 40.0;  ///< N/s beyond what the finger's own motion explains; 0.8 N in 20 ms
    double max_stiffness = 3.0;    ///< N/mm; a law that claims more explains no more
    double max_acceleration = 400.0; ///< m/s²; a faster change of the place explains no force
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
    double stiffness = 0.0; ///< N/mm, the most that the force changes with the place; 0: nothing is explained
};

/// The one place between any law and any device, and the only maker of a force that a device accepts.
///
/// In order: faults are noticed, what is not a number becomes zero, the gain ramps up after the first reading
/// and down on a fault, the magnitude is clamped, jumps are slowed. A fault of a moment heals when its cause is
/// gone: the gain ramps up again. A disabling fault stays until engage(). Not thread-safe; allocates nothing.
///
/// A change of the force that the finger's motion explains passes at once: a spring that lags feeds energy to
/// the hand. It is explained up to stiffness · |Δx|, of a motion no faster and no more sudden than a hand's.
/// The rest of a change (a new scene, another contour, a reading that jumped) becomes an offset from the wanted
/// force that goes at max_force_rate.
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
    /// The magnitude that holds from the next force on, also where the last one was larger.
    void set_max_force(double newtons) noexcept;
    double max_force() const noexcept { return max_force_; }

private:
    Fault notice(const SafetyInput& input, double elapsed) noexcept;
    void move_gain(const SafetyInput& input, double elapsed) noexcept;
    bool inside_workspace(Vec2 position) const noexcept;
    double explained(const SafetyInput& input) noexcept;

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
    Vec2 last_target_{0.0};     ///< N, what the last force was on its way to
    bool reading_seen_ = false; ///< before the first one no law knows the place
    Vec2 last_position_{0.0};   ///< mm, of the last fresh reading
    double position_time_ = 0.0;
    Vec2 motion_{0.0}; ///< mm/s, from reading to reading, no faster and no more sudden than a hand's
};

} // namespace tp
