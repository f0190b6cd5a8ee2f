// SPDX-License-Identifier: Apache-2.0
#include "device/haply_2diy/protocol/board_frames.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace tp::haply {

static_assert(std::numeric_limits<float>::is_iec559 && sizeof(float) == 4);

namespace {

constexpr float farthest_deg = 540.0f;
constexpr std::uint8_t no_type = 3;
constexpr std::size_t longest_frame =
    2 + 2 * (1 + 4) + 2 * (1 + 255) + 4 * 8; ///< that bytes out of step can ask for
constexpr double fastest_deg_per_s = 40.0 * 57.29577951308232;
constexpr double step_deg = 0.2; ///< above the coarsest encoder's 0.07

std::uint8_t code(FrameType type) { return static_cast<std::uint8_t>(type); }
std::uint8_t code(Turn turn) { return static_cast<std::uint8_t>(turn); }

void put(float value, std::uint8_t* at) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (unsigned i = 0; i < 4; ++i)
        at[i] = static_cast<std::uint8_t>(bits >> (8 * i));
}

float taken(const std::uint8_t* at) {
    std::uint32_t bits = 0;
    for (unsigned i = 0; i < 4; ++i)
        bits |= static_cast<std::uint32_t>(at[i]) << (8 * i);
    return std::bit_cast<float>(bits);
}

std::optional<Turn> turn_of(std::uint8_t byte) {
    return byte <= 1 ? std::optional(static_cast<Turn>(byte)) : std::nullopt;
}

/// A mask of ports and one byte of direction for each; false where that is not what comes next.
bool take_ports(std::span<const std::uint8_t> frame, std::size_t& at,
                std::array<std::optional<Turn>, port_count>& turns) {
    if (at >= frame.size() || frame[at] >= 1u << port_count)
        return false;
    const unsigned mask = frame[at++];
    for (std::size_t port = 0; port < port_count; ++port) {
        if ((mask >> port & 1u) == 0)
            continue;
        if (at >= frame.size() || !(turns[port] = turn_of(frame[at++])))
            return false;
    }
    return true;
}

} // namespace

std::array<std::uint8_t, 2> encode_reset(std::uint8_t device_id) {
    return {code(FrameType::reset), device_id};
}

SetUpBytes encode(const SetUp& set_up) {
    SetUpBytes made;
    const auto add = [&made](unsigned byte) { made.bytes[made.size++] = static_cast<std::uint8_t>(byte); };
    const auto add_ports = [&add](const auto& ports, auto turn) {
        unsigned mask = 0;
        for (std::size_t port = 0; port < port_count; ++port)
            mask |= ports[port] ? 1u << port : 0u;
        add(mask);
        for (const auto& one : ports)
            if (one)
                add(code(turn(*one)));
    };
    add(code(FrameType::set_up));
    add(set_up.device_id);
    add_ports(set_up.motors, [](Turn turn) { return turn; });
    add_ports(set_up.encoders, [](const EncoderSetUp& encoder) { return encoder.turn; });
    add(0); // pins of sensors
    add(0); // pins of other outputs
    for (const auto& encoder : set_up.encoders)
        if (encoder) {
            put(encoder->offset_deg, &made.bytes[made.size]);
            put(encoder->counts_per_turn, &made.bytes[made.size + 4]);
            made.size += 8;
        }
    return made;
}

std::optional<std::size_t> set_up_length(std::span<const std::uint8_t> begun) {
    std::size_t at = 2;
    std::size_t encoders = 0;
    for (int masks = 0; masks < 2; ++masks) {
        if (at >= begun.size())
            return std::nullopt;
        encoders = static_cast<std::size_t>(std::popcount(static_cast<unsigned>(begun[at] & 0x0Fu)));
        at += 1 + encoders;
    }
    for (int pins = 0; pins < 2; ++pins) {
        if (at >= begun.size())
            return std::nullopt;
        at += 1u + begun[at];
    }
    return at + 8 * encoders;
}

std::optional<SetUp> decode_set_up(std::span<const std::uint8_t> frame) {
    const std::optional<std::size_t> length = set_up_length(frame);
    if (!length || *length != frame.size() || frame[0] != code(FrameType::set_up))
        return std::nullopt;
    SetUp set_up;
    set_up.device_id = frame[1];
    std::size_t at = 2;
    std::array<std::optional<Turn>, port_count> turns;
    if (!take_ports(frame, at, set_up.motors) || !take_ports(frame, at, turns))
        return std::nullopt;
    if (frame[at] != 0 || frame[at + 1] != 0)
        return std::nullopt;
    at += 2;
    for (std::size_t port = 0; port < port_count; ++port) {
        if (!turns[port])
            continue;
        const EncoderSetUp encoder{*turns[port], taken(&frame[at]), taken(&frame[at + 4])};
        if (!std::isfinite(encoder.offset_deg) || !std::isfinite(encoder.counts_per_turn) ||
            !(encoder.counts_per_turn > 0))
            return std::nullopt;
        set_up.encoders[port] = encoder;
        at += 8;
    }
    return set_up;
}

std::array<std::uint8_t, command_size> encode(const Command& command) {
    std::array<std::uint8_t, command_size> frame{code(FrameType::command), command.device_id};
    put(command.torque[0], &frame[2]);
    put(command.torque[1], &frame[6]);
    return frame;
}

std::optional<Command> decode_command(std::span<const std::uint8_t, command_size> frame) {
    const Command command{frame[1], {taken(&frame[2]), taken(&frame[6])}};
    if (frame[0] != code(FrameType::command) || !std::isfinite(command.torque[0]) ||
        !std::isfinite(command.torque[1]))
        return std::nullopt;
    return command;
}

float sendable(double torque) {
    if (!(std::abs(torque) <= 1.0))
        return 0.0f;
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(torque));
    const float cut = std::bit_cast<float>(bits & 0xFFFF0000u);
    return std::isnormal(cut) ? cut : 0.0f;
}

std::array<std::uint8_t, reply_size> encode(const Reply& reply) {
    std::array<std::uint8_t, reply_size> frame{reply.device_id};
    put(reply.angle_deg[0], &frame[1]);
    put(reply.angle_deg[1], &frame[5]);
    return frame;
}

std::optional<Reply> decode_reply(std::span<const std::uint8_t, reply_size> frame) {
    const Reply reply{frame[0], {taken(&frame[1]), taken(&frame[5])}};
    for (const float angle : reply.angle_deg)
        if (!(std::abs(angle) <= farthest_deg))
            return std::nullopt;
    return reply;
}

bool can_follow(const Reply& before, const Reply& after, double seconds) {
    const double most = step_deg + fastest_deg_per_s * std::max(0.0, seconds);
    for (std::size_t i = 0; i < 2; ++i)
        if (!(std::abs(static_cast<double>(after.angle_deg[i]) - static_cast<double>(before.angle_deg[i])) <=
              most))
            return false;
    return true;
}

ResynchronisationBytes resynchronisation(const SetUp& set_up, unsigned round) {
    ResynchronisationBytes made;
    // Resets go by twos; the byte behind them is the id of the last, or begins no frame. One more in every
    // second round, for a firmware that makes something else of that byte.
    made.size = longest_frame + round % 2;
    made.bytes[made.size++] = no_type;
    const auto add = [&made](std::span<const std::uint8_t> bytes) {
        std::copy(bytes.begin(), bytes.end(), made.bytes.begin() + static_cast<std::ptrdiff_t>(made.size));
        made.size += bytes.size();
    };
    add(encode(set_up).view());
    add(encode(Command{set_up.device_id, {}}));
    return made;
}

} // namespace tp::haply
