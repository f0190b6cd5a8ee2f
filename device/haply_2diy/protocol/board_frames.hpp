// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

/// What a computer and the Haply board say to each other over the serial line, as pure functions (Haply's
/// published firmware and hAPI). Little endian, floats IEEE-754. Nothing marks where a frame begins, nothing
/// checks it: a lost byte puts both sides out of step until the computer sends resynchronisation().
namespace tp::haply {

inline constexpr std::size_t port_count = 4;
inline constexpr std::size_t command_size = 10;
inline constexpr std::size_t reply_size = 9;
inline constexpr std::uint8_t usual_id = 5; ///< of the 2diy, by convention

enum class FrameType : std::uint8_t { reset = 0, set_up = 1, command = 2 };
enum class Turn : std::uint8_t { clockwise = 0, counter_clockwise = 1 };

/// The board forgets its set-up. What its motors pull stays.
std::array<std::uint8_t, 2> encode_reset(std::uint8_t device_id);

struct EncoderSetUp {
    Turn turn = Turn::clockwise;
    float offset_deg = 0;      ///< the angle at which it stands now: it only counts from there
    float counts_per_turn = 1; ///< > 0
};

/// Which motors and encoders stand at which ports, [0] being port 1; no pins for sensors or other outputs,
/// which a 2diy does not have.
struct SetUp {
    std::uint8_t device_id = usual_id;
    std::array<std::optional<Turn>, port_count> motors;
    std::array<std::optional<EncoderSetUp>, port_count> encoders;
};

struct SetUpBytes {
    std::array<std::uint8_t, 46> bytes{};
    std::size_t size = 0;
    std::span<const std::uint8_t> view() const { return {bytes.data(), size}; }
    const std::uint8_t* begin() const { return bytes.data(); }
    const std::uint8_t* end() const { return bytes.data() + size; }
};
SetUpBytes encode(const SetUp& set_up);
/// How long a set-up is that begins with these bytes, as the board reads it (with pins too); none before that
/// can be known.
std::optional<std::size_t> set_up_length(std::span<const std::uint8_t> begun);
/// None for what encode() does not make.
std::optional<SetUp> decode_set_up(std::span<const std::uint8_t> frame);

/// What the two motors shall pull, by port; the board holds it until it is told otherwise.
struct Command {
    std::uint8_t device_id = usual_id;
    std::array<float, 2> torque{}; ///< N·m
};
std::array<std::uint8_t, command_size> encode(const Command& command);
/// None for another type and for what is not a number.
std::optional<Command> decode_command(std::span<const std::uint8_t, command_size> frame);

/// The torque nearest to this one and not above it whose two low bytes are zero, exact to 1 %; 0 for what is
/// no number or above 1 N·m. In a command that lost one or two bytes those zeros stand where the exponents
/// should, and the board pulls nothing.
float sendable(double torque);

/// The board's answer to a command, by port.
struct Reply {
    std::uint8_t device_id = usual_id;
    std::array<float, 2> angle_deg{};
};
std::array<std::uint8_t, reply_size> encode(const Reply& reply);
/// None for what is not a number or more than a turn and a half from zero, which no arm can be.
std::optional<Reply> decode_reply(std::span<const std::uint8_t, reply_size> frame);

/// Whether arms can have gone from one reading to the next in `seconds` (40 rad/s, twice what the fastest
/// hand does, and a step of the encoder).
bool can_follow(const Reply& before, const Reply& after, double seconds);

/// What brings the board back into step from wherever it stands, for the `round`th try in a row: the rest of
/// any frame it waits for, as zeros, which are also resets; then its set-up and a command of no torque, which
/// it answers.
struct ResynchronisationBytes {
    std::array<std::uint8_t, 640> bytes{};
    std::size_t size = 0;
    std::span<const std::uint8_t> view() const { return {bytes.data(), size}; }
    const std::uint8_t* begin() const { return bytes.data(); }
    const std::uint8_t* end() const { return bytes.data() + size; }
};
ResynchronisationBytes resynchronisation(const SetUp& set_up, unsigned round);

} // namespace tp::haply
