// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

/// A Novint Falcon's packets: 16 bytes each way, one reply to each command. Facts: libnifalcon at f7c727a.
namespace tp::falcon {

inline constexpr std::size_t packet_size = 16;
using Packet = std::array<std::uint8_t, packet_size>;

/// What a motor takes at most, in its own units; beyond it the packet's numbers would wrap.
inline constexpr int most_motor = 4096;

namespace led {
inline constexpr std::uint8_t green = 2;
inline constexpr std::uint8_t blue = 4;
inline constexpr std::uint8_t red = 8;
} // namespace led

namespace button {
inline constexpr std::uint8_t plus = 1;
inline constexpr std::uint8_t forward = 2;
inline constexpr std::uint8_t centre = 4;
inline constexpr std::uint8_t minus = 8;
} // namespace button

/// From the computer.
struct Command {
    std::array<std::int16_t, 3> motors{}; ///< motor units, −most_motor … most_motor
    bool homing = false;                  ///< each arm takes its place from its mark when it passes it
    std::uint8_t leds = 0;                ///< of led
    bool operator==(const Command&) const = default;
};

/// From the Falcon.
struct Reply {
    std::array<std::int16_t, 3> encoders{}; ///< counts
    std::uint8_t buttons = 0;               ///< of button
    std::uint8_t homed = 0;                 ///< a bit for each arm; 7: all know where they are
    bool operator==(const Reply&) const = default;
};

/// Motors are clamped.
Packet encode(const Command& command);
Packet encode(const Reply& reply);
/// Nothing where the packet is none. A reply's last byte but one has no known meaning and is not looked at.
std::optional<Command> decode_command(const Packet& packet);
std::optional<Reply> decode_reply(const Packet& packet);

/// Motor units as they can be sent: rounded towards zero, so that a force never grows; not a number is none.
std::int16_t motor_units(double wanted);

/// Whole packets out of a stream of bytes that may begin anywhere and lose some on the way.
class PacketStream {
public:
    /// The packet that ends with this byte, if one does.
    std::optional<Packet> push(std::uint8_t byte);
    /// Bytes so far that belonged to no packet.
    std::uint64_t strays() const { return strays_; }

private:
    Packet held_{};
    std::size_t count_ = 0;
    std::uint64_t strays_ = 0;
};

} // namespace tp::falcon
