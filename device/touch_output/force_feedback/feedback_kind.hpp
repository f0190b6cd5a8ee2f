// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <cstddef>

namespace tp {

/// What a device says it can play: the FF_ bits of linux/input-event-codes.h.
using FeedbackBits = std::bitset<128>;

namespace feedback_bit {
inline constexpr std::size_t rumble = 0x50;
inline constexpr std::size_t periodic = 0x51;
inline constexpr std::size_t constant = 0x52; ///< this and the next five push in a direction
inline constexpr std::size_t ramp = 0x57;
inline constexpr std::size_t square = 0x58;
inline constexpr std::size_t triangle = 0x59;
inline constexpr std::size_t sine = 0x5a;
inline constexpr std::size_t gain = 0x60;
} // namespace feedback_bit

/// How a tick is played on a device.
enum class FeedbackKind {
    none,       ///< it cannot be
    motor,      ///< one motor that shakes the machine, as phones have
    two_motors, ///< a slow, strong one and a fast, weak one, as game pads have
    sine,       ///< short waves of a frequency, as haptic actuators have
    square
};

/// By what the device says. A wheel or stick whose force has a direction is none of these: it could push a hand. Waves that
/// the kernel only pretends (ff-memless offers sine, square and triangle where a driver has nothing but a motor) are a motor.
/// A device with other waves of its own alone is none: nobody knows what they feel like.
FeedbackKind feedback_kind(const FeedbackBits& bits, bool game_pad);

/// It plays waves, and not a motor.
constexpr bool plays_waves(FeedbackKind kind) {
    return kind == FeedbackKind::sine || kind == FeedbackKind::square;
}

} // namespace tp
