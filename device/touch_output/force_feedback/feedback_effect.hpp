// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/touch/tick.hpp"
#include "device/touch_output/force_feedback/feedback_kind.hpp"

#include <cstdint>

namespace tp {

/// What is played once, at once, and ends by itself.
struct FeedbackEffect {
    std::uint16_t strong = 0;    ///< of the slow motor, or of the only one, or of the wave: 0 … 65535
    std::uint16_t weak = 0;      ///< of the fast motor
    std::uint16_t period_ms = 0; ///< of the wave; 0 for motors
    std::uint16_t length_ms = 0; ///< never 0 of what is played: that would be without an end

    bool operator==(const FeedbackEffect&) const = default;
};

/// s: a shorter tick lasts as long. A motor is not felt before it turns; a wave of the lowest frequency needs its period.
/// Chosen, not measured on any device.
double shortest_feedback_s(FeedbackKind kind);

/// s from a tick that is told to one that is felt: a motor has to get going. An estimate.
double feedback_delay_s(FeedbackKind kind);

/// A tick as it is played. On one motor only its amplitude is felt; of two the slow one is a soft tick, the fast one a sharp
/// tick; a wave is the higher the sharper the tick, 125 … 250 Hz.
FeedbackEffect feedback_of(const Tick& tick, FeedbackKind kind) noexcept;

/// An effect as the word that a LatestWriter carries, never 0 of one that has a length, and back.
std::uint64_t packed(const FeedbackEffect& effect) noexcept;
FeedbackEffect unpacked_feedback(std::uint64_t word) noexcept;

} // namespace tp
