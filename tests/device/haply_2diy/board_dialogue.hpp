// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/guard/simulated_guard.hpp"
#include "device/haply_2diy/haply_2diy.hpp"
#include "device/haply_2diy/protocol/board_frames.hpp"
#include "safe_force.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tp::testing {

/// A board that answers as a test has it, and keeps what it was sent.
struct BoardScript final : SerialLine {
    const Pantograph arms{HaplyGeneration::third};
    haply::Reply here = arms.reply_of(arms.reference_deg());
    bool answers = true;
    int unanswered = 0; ///< of the first questions
    bool reads_fail = false;
    bool writes_fail = false;
    std::size_t at_once = 1000;  ///< bytes
    std::size_t junk_before = 0; ///< bytes before each answer
    std::deque<std::uint8_t> to_say;
    std::vector<std::vector<std::uint8_t>> sent;
    int reads = 0;
    int waited_ms = 0; ///< in reads, at the most
    int users = 0;     ///< who have the line open

    void say(const haply::Reply& reply) {
        for (const std::uint8_t byte : haply::encode(reply))
            to_say.push_back(byte);
    }
    int read(std::span<std::uint8_t> into, int wait_ms) noexcept override {
        ++reads;
        waited_ms += wait_ms;
        if (reads_fail)
            return -1;
        const std::size_t count = std::min({into.size(), to_say.size(), at_once});
        std::copy_n(to_say.begin(), count, into.begin());
        to_say.erase(to_say.begin(), to_say.begin() + static_cast<std::ptrdiff_t>(count));
        return static_cast<int>(count);
    }
    bool write(std::span<const std::uint8_t> bytes) noexcept override {
        if (writes_fail)
            return false;
        sent.emplace_back(bytes.begin(), bytes.end());
        if (answers && unanswered-- <= 0) {
            to_say.insert(to_say.end(), junk_before, 0xEE);
            say(here);
        }
        return true;
    }
    std::optional<haply::Command> last_command() const {
        if (sent.empty() || sent.back().size() != haply::command_size)
            return std::nullopt;
        return haply::decode_command(std::span(sent.back()).first<haply::command_size>());
    }
};

struct LentScript final : SerialLine {
    explicit LentScript(BoardScript& lent) : script(lent) { ++script.users; }
    ~LentScript() override { --script.users; }
    LentScript(const LentScript&) = delete;
    LentScript& operator=(const LentScript&) = delete;
    int read(std::span<std::uint8_t> into, int wait_ms) noexcept override {
        return script.read(into, wait_ms);
    }
    bool write(std::span<const std::uint8_t> bytes) noexcept override { return script.write(bytes); }
    BoardScript& script;
};

/// The back end of a board whose every byte is written by hand.
struct BoardDialogue {
    BoardScript script;
    GuardDiary guard;
    HomedNote note; ///< none
    Haply2diy device{HaplyGeneration::third,
                     [this]() -> Result<Haply2diy::Board> {
                         return Haply2diy::Board{std::make_unique<LentScript>(script),
                                                 std::make_unique<SimulatedGuard>(guard), note, "X"};
                     },
                     LatestWriter::Thread::caller};
    double now = 0.0;
    Result<Capabilities> can = Error{"not open"};

    /// Homed; from here on a test says what comes.
    bool open() {
        script.answers = true;
        can = device.open();
        const bool homed = can.ok() && device.home().ok();
        script.answers = false;
        script.to_say.clear();
        script.sent.clear();
        return homed;
    }
    /// Until its encoders are not believed any more.
    bool falls_out_of_step() {
        for (int i = 0; i < 25; ++i)
            tick({0.5, 0.5});
        return device.complaint().find("lost count") != std::string::npos;
    }
    std::optional<DeviceState> tick(Vec2 newtons, double dt = 0.001) {
        const std::optional<DeviceState> state = device.read(now += dt);
        device.write(safe(newtons));
        device.deliver();
        return state;
    }
    /// What a force is on the wire for arms that stand where that reply says.
    std::array<float, 2> asked_for(Vec2 newtons, const haply::Reply& at) const {
        return script.arms.command_of(script.arms.torques(script.arms.angles_of(at), newtons)).torque;
    }
    /// The reference pose, its first arm turned on by so much.
    haply::Reply turned(double degrees) const {
        std::array<double, 2> angles = script.arms.reference_deg();
        angles[0] += degrees;
        return script.arms.reply_of(angles);
    }
};

} // namespace tp::testing
