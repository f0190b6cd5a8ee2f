// SPDX-License-Identifier: Apache-2.0
#include "board_check.hpp"

#include "device/haply_2diy/model_board.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace tp::test {

using namespace tp::haply;

namespace {

bool same(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

template <std::size_t size, typename Decode>
bool survive(std::span<const std::uint8_t> bytes, Decode decode) {
    for (std::size_t at = 0; at + size <= bytes.size(); ++at) {
        const auto frame = bytes.subspan(at).template first<size>();
        if (const auto value = decode(frame); value && !same(encode(*value), frame))
            return false;
    }
    return true;
}

bool within_limits(const ModelBoard& board) {
    for (const double torque : board.torques())
        if (!(std::abs(torque) <= Pantograph::greatest_torque + 1e-8))
            return false;
    return true;
}

} // namespace

std::string complaint_about_board_bytes(std::string_view text) {
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    if (!survive<reply_size>(bytes, decode_reply) || !survive<command_size>(bytes, decode_command))
        return "a frame that is taken is not given back as it came";
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        const auto rest = std::span(bytes).subspan(at);
        const auto length = set_up_length(rest);
        if (!length || *length > rest.size())
            continue;
        if (const auto set_up = decode_set_up(rest.first(*length));
            set_up && !same(encode(*set_up).view(), rest.first(*length)))
            return "a set-up that is taken is not given back as it came";
    }
    const Pantograph arms(HaplyGeneration::third);
    const SetUp set_up = arms.set_up(arms.reference_deg());
    ModelBoard board(HaplyGeneration::third);
    for (const std::uint8_t byte : encode(set_up))
        board.receive(byte);
    for (const std::uint8_t byte : bytes) {
        board.receive(byte);
        if (!within_limits(board))
            return "a motor pulls harder than it can";
    }
    constexpr unsigned most_rounds = 2;
    const auto wanted = encode(arms.reply_of(arms.reference_deg()));
    for (unsigned round = 0; round < most_rounds; ++round) {
        board.sent().clear();
        for (const std::uint8_t byte : resynchronisation(set_up, round))
            board.receive(byte);
        const std::vector<std::uint8_t> answer(board.sent().begin(), board.sent().end());
        if (answer.size() >= reply_size && same(std::span(answer).last(reply_size), wanted) &&
            board.torques() == std::array<double, 2>{})
            return {};
    }
    return "a board is not brought back into step";
}

} // namespace tp::test
