// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/chance.hpp"
#include "core/handheld/held_pose.hpp"

#include <array>
#include <cstdint>

namespace tp {

/// How a hand that wants to be still is not.
struct TremorManner {
    /// Peak acceleration of the hand: the modal value of 97 healthy people, 0.0015 to 0.035 g among them (Wade, Gresty, Findley,
    /// "A normative study of postural tremor of the hand", Arch Neurol 39:358, 1982).
    double peak_g = 0.01;
    double rate_hz = 7.0;   ///< the modal frequency (the same)
    double lever_m = 0.1;   ///< from the wrist to the camera's middle (assumed): half a hand
    double sway_deg = 0.6;  ///< standard deviation of the slow wander of an arm held out (assumed)
    double sway_s = 2.0;    ///< time constant of it (assumed)
    double inertia_s = 0.5; ///< an arm follows no faster (assumed)

    /// Degrees to either side.
    double tremor_deg() const;
};

/// What tremor and sway add to a pose, step after step.
class HandTremor {
public:
    HandTremor(TremorManner manner, std::uint64_t seed);
    /// `dt` s later, > 0.
    void step(double dt);
    HeldPose added_to(HeldPose pose) const;

private:
    TremorManner manner_;
    Chance chance_;
    std::array<double, 3> phase_{}; ///< of pan, tilt and roll, radians
    std::array<double, 3> rate_{};  ///< Hz
    std::array<double, 3> pull_{};  ///< degrees: where the arm wanders to
    std::array<double, 3> sway_{};  ///< degrees: where it is
};

} // namespace tp
