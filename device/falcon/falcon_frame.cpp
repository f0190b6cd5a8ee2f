// SPDX-License-Identifier: Apache-2.0
#include "device/falcon/falcon_frame.hpp"

#include <algorithm>
#include <cmath>

namespace tp::falcon {

namespace {

constexpr std::uint8_t opening = '<';
constexpr std::uint8_t closing = '>';
constexpr std::uint8_t zero_letter = 'A'; ///< a nibble of zero
constexpr std::size_t flags_at = 13;
constexpr std::size_t spare_at = 14;

Packet packet_of(const std::array<std::int16_t, 3>& numbers, unsigned flags) {
    Packet packet{};
    packet.front() = opening;
    packet.back() = closing;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        for (std::size_t nibble = 0; nibble < 4; ++nibble)
            packet[1 + 4 * i + nibble] = static_cast<std::uint8_t>(
                zero_letter + ((static_cast<std::uint16_t>(numbers[i]) >> (4 * nibble)) & 0xFu));
    packet[flags_at] = static_cast<std::uint8_t>(zero_letter + flags);
    packet[spare_at] = zero_letter;
    return packet;
}

bool well_formed(const Packet& packet) {
    return packet.front() == opening && packet.back() == closing &&
           std::all_of(packet.begin() + 1, packet.begin() + flags_at,
                       [](std::uint8_t byte) { return byte >= zero_letter && byte < zero_letter + 16; });
}

std::array<std::int16_t, 3> numbers_of(const Packet& packet) {
    std::array<std::int16_t, 3> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        unsigned bits = 0;
        for (std::size_t nibble = 0; nibble < 4; ++nibble)
            bits |= static_cast<unsigned>(packet[1 + 4 * i + nibble] - zero_letter) << (4 * nibble);
        numbers[i] = static_cast<std::int16_t>(bits);
    }
    return numbers;
}

} // namespace

Packet encode(const Command& command) {
    std::array<std::int16_t, 3> motors = command.motors;
    for (std::int16_t& motor : motors)
        motor = static_cast<std::int16_t>(std::clamp<int>(motor, -most_motor, most_motor));
    return packet_of(motors,
                     (command.homing ? 1u : 0u) | (command.leds & (led::green | led::blue | led::red)));
}

Packet encode(const Reply& reply) {
    return packet_of(reply.encoders, (reply.buttons & 0xFu) | ((reply.homed & 7u) << 4));
}

std::optional<Command> decode_command(const Packet& packet) {
    const int flags = packet[flags_at] - zero_letter;
    if (!well_formed(packet) || flags < 0 || flags > 0xF || packet[spare_at] != zero_letter)
        return std::nullopt;
    Command command;
    command.motors = numbers_of(packet);
    for (const int motor : command.motors)
        if (motor < -most_motor || motor > most_motor)
            return std::nullopt;
    command.homing = (flags & 1) != 0;
    command.leds = static_cast<std::uint8_t>(flags & (led::green | led::blue | led::red));
    return command;
}

std::optional<Reply> decode_reply(const Packet& packet) {
    const int flags = packet[flags_at] - zero_letter;
    if (!well_formed(packet) || flags < 0 || flags > 0x7F)
        return std::nullopt;
    Reply reply;
    reply.encoders = numbers_of(packet);
    reply.buttons = static_cast<std::uint8_t>(flags & 0xF);
    reply.homed = static_cast<std::uint8_t>(flags >> 4);
    return reply;
}

std::int16_t motor_units(double wanted) {
    if (std::isnan(wanted))
        return 0;
    return static_cast<std::int16_t>(
        std::clamp(wanted, static_cast<double>(-most_motor), static_cast<double>(most_motor)));
}

std::optional<Packet> PacketStream::push(std::uint8_t byte) {
    held_[count_++] = byte;
    if (count_ == packet_size && well_formed(held_)) {
        count_ = 0;
        return held_;
    }
    if (count_ == packet_size || held_.front() != opening) {
        // What follows the next opening byte may still be a packet.
        const auto from =
            std::find(held_.begin() + 1, held_.begin() + static_cast<std::ptrdiff_t>(count_), opening);
        const auto end = std::copy(from, held_.begin() + static_cast<std::ptrdiff_t>(count_), held_.begin());
        strays_ += static_cast<std::uint64_t>(from - held_.begin());
        count_ = static_cast<std::size_t>(end - held_.begin());
    }
    return std::nullopt;
}

} // namespace tp::falcon
