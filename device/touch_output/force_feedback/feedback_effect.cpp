// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/force_feedback/feedback_effect.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

constexpr double soft_period_ms = 8.0;
constexpr double sharp_period_ms = 4.0;
constexpr double fast_motor_from = 0.5; ///< sharpness

std::uint16_t whole(double value) { return static_cast<std::uint16_t>(std::lround(value)); }

} // namespace

double shortest_feedback_s(FeedbackKind kind) { return plays_waves(kind) ? 0.001 * soft_period_ms : 0.04; }

double feedback_delay_s(FeedbackKind kind) { return plays_waves(kind) ? 0.01 : 0.03; }

FeedbackEffect feedback_of(const Tick& tick, FeedbackKind kind) noexcept {
    FeedbackEffect effect;
    if (tick.empty() || kind == FeedbackKind::none)
        return effect;
    const std::uint16_t strength = whole(65535.0 * tick.amplitude());
    const bool fast = kind == FeedbackKind::two_motors && tick.sharpness() >= fast_motor_from;
    (fast ? effect.weak : effect.strong) = strength;
    if (plays_waves(kind))
        effect.period_ms = whole(std::lerp(soft_period_ms, sharp_period_ms, tick.sharpness()));
    effect.length_ms = whole(1000.0 * std::max(tick.seconds(), shortest_feedback_s(kind)));
    return effect;
}

std::uint64_t packed(const FeedbackEffect& effect) noexcept {
    return std::uint64_t{effect.strong} | std::uint64_t{effect.weak} << 16 |
           std::uint64_t{effect.period_ms} << 32 | std::uint64_t{effect.length_ms} << 48;
}

FeedbackEffect unpacked_feedback(std::uint64_t word) noexcept {
    const auto part = [word](unsigned shift) { return static_cast<std::uint16_t>(word >> shift); };
    return {part(0), part(16), part(32), part(48)};
}

} // namespace tp
