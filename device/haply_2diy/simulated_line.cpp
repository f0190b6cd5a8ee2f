// SPDX-License-Identifier: Apache-2.0
#include "device/haply_2diy/simulated_line.hpp"

#include <algorithm>

namespace tp {

bool SimulatedLine::happens(double share) {
    return share > 0.0 && std::uniform_real_distribution<double>(0.0, 1.0)(random_) < share;
}

void SimulatedLine::take_answer() {
    std::deque<std::uint8_t>& sent = board_.sent();
    if (sent.empty())
        return;
    std::vector<std::uint8_t> answer(sent.begin(), sent.end());
    sent.clear();
    if (troubles.mute || troubles.unplugged)
        return;
    if (happens(troubles.half))
        answer.resize(random_() % answer.size());
    if (happens(troubles.garbage))
        for (unsigned i = 0; i < 1 + random_() % 8 && !answer.empty(); ++i)
            answer[random_() % answer.size()] = static_cast<std::uint8_t>(random_());
    for (const std::uint8_t byte : answer)
        if (!happens(troubles.drop_from_board))
            from_board_.push_back({now_ + later_ms_, byte});
}

void SimulatedLine::advance() {
    ++now_;
    if (!troubles.stall) {
        for (const std::vector<std::uint8_t>& bytes : to_board_)
            for (const std::uint8_t byte : bytes)
                board_.receive(byte);
        to_board_.clear();
        take_answer();
    }
    board_.step();
}

int SimulatedLine::read(std::span<std::uint8_t> into, int wait_ms) noexcept {
    for (;; --wait_ms) {
        if (troubles.unplugged)
            return -1;
        int got = 0;
        while (!troubles.stall && static_cast<std::size_t>(got) < into.size() && !from_board_.empty() &&
               from_board_.front().due <= now_) {
            into[static_cast<std::size_t>(got++)] = from_board_.front().byte;
            from_board_.pop_front();
        }
        if (got > 0 || wait_ms <= 0)
            return got;
        advance();
    }
}

bool SimulatedLine::write(std::span<const std::uint8_t> bytes) noexcept {
    if (troubles.unplugged)
        return false;
    std::vector<std::uint8_t> sent(bytes.begin(), bytes.end());
    if (troubles.half_write) {
        troubles.half_write = false;
        sent.resize(sent.size() / 2);
    }
    if (happens(troubles.drop_to_board) && sent.size() > 2) {
        const auto from = static_cast<std::ptrdiff_t>(random_() % (sent.size() - 1));
        sent.erase(sent.begin() + from, sent.begin() + from + 1 + static_cast<std::ptrdiff_t>(random_() % 2));
    }
    to_board_.push_back(std::move(sent));
    return true;
}

} // namespace tp
