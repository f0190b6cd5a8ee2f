// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/velocity_filter.hpp"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

namespace tp::falcon {

/// Where the plane lies in which a face is felt: upright before the person, m from the base, in the middle of
/// the reach.
inline constexpr double plane_z = 0.125;

/// Motor units that a newton metre at an arm takes. Nobody has published a measurement: recorded commands of
/// its maker's program come to 53 to 61 units per newton along z, libnifalcon sends 242 (at z = 0.11 m, where
/// a newton takes 0.0242 N·m). The least of them is taken, so that a person never feels more than was meant.
inline constexpr double units_per_newton_metre = 53.0 / 0.02418;

/// Motor units that push the grip with `force` (N; x right, y up, z to the person), all made smaller together
/// where one would be more than a motor takes. Not a number: none.
std::array<std::int16_t, 3> motors_for(const glm::dmat3& jacobian, const glm::dvec3& force);

/// Keeps the grip from being pushed through the plane, as a pane of glass would: a spring that only pushes,
/// towards the person, as the paper kept the pen of its PHANToM. From one side only, so that nothing ever
/// pulls a hand, who draws back is free, and a grip that is let go comes to rest before it and cannot swing
/// about it.
class Pane {
public:
    static constexpr double stiffness = 300.0; ///< N/m: a finger's push of 0.5 N goes in by 1.7 mm
    static constexpr double damping = 6.0;     ///< N·s/m, so that what springs out of it does not fly
    static constexpr double most = 1.5;        ///< N, hard
    static constexpr double most_rise = 0.04;  ///< N from one force to the next: 40 N/s at 1 kHz

    /// Where the grip is, m, at that time, s.
    void feed(double time, double z) noexcept;
    /// In each tick, at `now` s, after what it has fed: the speed does not outlive its places (VelocityFilter).
    void elapse(double now) noexcept { speed_.elapse(now); }
    /// N towards the person, 0 … most, of which `share` (0 … 1) is let in. Falls at once, rises by most_rise.
    double force(double share) noexcept;

private:
    bool known_ = false;
    double time_ = 0.0;
    double z_ = plane_z;
    VelocityFilter speed_; ///< along x, m/s towards the person; at 40 Hz, one count at 1 kHz is 0.05 m/s
    double last_ = 0.0;  ///< N
};

} // namespace tp::falcon
