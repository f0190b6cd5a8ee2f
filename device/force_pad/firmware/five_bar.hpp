// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/force_pad/firmware/number.hpp"

namespace tp::pad {

inline constexpr int arm_count = 2;

/// A pantograph: two motors at (0, 0) and (base, 0), two proximal links of one length, two distal links of
/// one length that meet in the knob on the side of larger y (Campion, Wang, Hayward, IROS 2005; the signs
/// from differentiating |P − A| = |P − B| = distal).
template <typename Real>
struct FiveBar {
    Real proximal = 0; ///< mm
    Real distal = 0;   ///< mm
    Real base = 0;     ///< mm, ≥ 0
};

template <typename Real>
struct FiveBarPose {
    Vec<Real> place;    ///< mm
    Vec<Real> link[arm_count];  ///< mm, from each elbow to the knob
    Vec<Real> swing[arm_count]; ///< mm, how each elbow moves per rad of its motor
    /// Sine of the angle between the distal links: 0 in a singular pose, where they lie in one line and some
    /// forces need torques without bound.
    Real spread = 0;
    bool reachable = false; ///< the elbows are near enough, and not in one place
};

/// Where the knob is by the motors' angles, rad from the x axis.
template <typename Real>
FiveBarPose<Real> locate(const FiveBar<Real>& bars, const Real (&angles)[arm_count]);

template <typename Real>
struct Torques {
    Real newton_mm[arm_count] = {};
    Vec<Real> force;      ///< N, what they make
    bool limited = false; ///< it is smaller than what was wanted, in the same direction
};

/// Torques, N·mm, that make the force `wanted`, N; made smaller together where a motor's limit asks for it,
/// so that the direction stays. A pose with less than `least_spread` makes no force at all.
template <typename Real>
Torques<Real> torques(const FiveBarPose<Real>& pose, Vec<Real> wanted, Real greatest_torque,
                      Real least_spread);

} // namespace tp::pad
