// SPDX-License-Identifier: Apache-2.0
#include "core/handheld/hand_tremor.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace tp {

namespace {
constexpr double gravity = 9.81; ///< m/s²
constexpr double rate_spread = 0.15;
} // namespace

double TremorManner::tremor_deg() const {
    const double turns = 2.0 * std::numbers::pi * rate_hz;
    return peak_g * gravity / (turns * turns) / lever_m * 180.0 / std::numbers::pi;
}

HandTremor::HandTremor(TremorManner manner, std::uint64_t seed) : manner_(manner), chance_(seed) {
    for (std::size_t i = 0; i < phase_.size(); ++i) {
        phase_[i] = chance_.between(0.0, 2.0 * std::numbers::pi);
        rate_[i] = manner_.rate_hz * chance_.factor(rate_spread);
        sway_[i] = pull_[i] = manner_.sway_deg * chance_.normal();
    }
}

void HandTremor::step(double dt) {
    const double keeps = std::exp(-dt / manner_.sway_s);
    // A low-pass takes this share of the pull's variance away.
    const double pull_deg = manner_.sway_deg * std::sqrt(1.0 + manner_.inertia_s / manner_.sway_s);
    const double pushes = pull_deg * std::sqrt(1.0 - keeps * keeps);
    const double follows = 1.0 - std::exp(-dt / manner_.inertia_s);
    for (std::size_t i = 0; i < phase_.size(); ++i) {
        phase_[i] = std::fmod(phase_[i] + 2.0 * std::numbers::pi * rate_[i] * dt, 2.0 * std::numbers::pi);
        pull_[i] = keeps * pull_[i] + pushes * chance_.normal();
        sway_[i] += follows * (pull_[i] - sway_[i]);
    }
}

HeldPose HandTremor::added_to(HeldPose pose) const {
    const double tremor = manner_.tremor_deg();
    pose.pan_deg += sway_[0] + tremor * std::sin(phase_[0]);
    pose.tilt_deg += sway_[1] + tremor * std::sin(phase_[1]);
    pose.roll_deg += sway_[2] + tremor * std::sin(phase_[2]);
    return pose;
}

} // namespace tp
