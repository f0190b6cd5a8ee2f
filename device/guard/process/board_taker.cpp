// SPDX-License-Identifier: Apache-2.0
#include "device/guard/process/ends.hpp"
#include "device/guard/process/force_taker.hpp"
#include "device/haply_2diy/protocol/board_frames.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace tp::guard {

using namespace tp::haply;

namespace {

constexpr int answer_ms = 30;
/// A command of no torque; more than can be answered without having been obeyed: what the program's last ones
/// may still be answered with, and one that the board makes of a half frame of the program and half of ours.
constexpr std::size_t times = 5;
constexpr unsigned rounds = 20;

bool write_line(std::span<const std::uint8_t> bytes) { return write_all(End::device, bytes); }

/// Whether these are a board's answers to commands and nothing else.
bool are_replies(std::span<const std::uint8_t> bytes, std::uint8_t id) {
    for (; bytes.size() >= reply_size; bytes = bytes.subspan(reply_size))
        if (const auto reply = decode_reply(bytes.first<reply_size>()); !reply || reply->device_id != id)
            return false;
    return true;
}

/// Whether the last that a board answers are so many replies to commands.
bool answered(std::uint8_t id, std::size_t replies) {
    std::vector<std::uint8_t> heard;
    std::array<std::uint8_t, 256> some{};
    while (heard.size() < 4096) {
        const int got = read_within(End::device, some, answer_ms);
        if (got <= 0)
            return false;
        heard.insert(heard.end(), some.begin(), some.begin() + got);
        if (heard.size() >= replies * reply_size &&
            are_replies(std::span(heard).last(replies * reply_size), id))
            return true;
    }
    return false;
}

/// Whether the board is in step and has taken the torque away, as it was told.
bool obeys(std::uint8_t id) {
    for (std::size_t i = 0; i < times; ++i)
        if (!write_line(encode(Command{id, {}})))
            return false;
    return answered(id, times);
}

void drop_what_came() {
    std::array<std::uint8_t, 4096> some{};
    while (read_within(End::device, some, 0) > 0) {
    }
}

void take_torque_away(const SetUp& set_up) {
    drop_what_came();
    if (obeys(set_up.device_id))
        return;
    // The program died in the middle of a frame, or the board is out of step.
    for (unsigned round = 0; round < rounds; ++round) {
        if (!write_line(resynchronisation(set_up, round).view()))
            return;
        if (answered(set_up.device_id, 1) && obeys(set_up.device_id)) {
            write_line(
                encode_reset(set_up.device_id)); // its angles are not those it had: nobody shall believe them
            return;
        }
    }
}

class BoardTaker final : public ForceTaker {
public:
    explicit BoardTaker(const SetUp& set_up) : set_up_(set_up) {}
    bool let_go() override {
        take_torque_away(set_up_);
        return false; // the board may have lost its angles
    }
    /// What a board pulls that is out of step nobody knows.
    void leave(bool) override { take_torque_away(set_up_); }

private:
    SetUp set_up_;
};

} // namespace

std::unique_ptr<ForceTaker> board_taker(const Bytes& set_up) {
    const auto decoded = decode_set_up(set_up);
    return decoded ? std::make_unique<BoardTaker>(*decoded) : nullptr;
}

} // namespace tp::guard
