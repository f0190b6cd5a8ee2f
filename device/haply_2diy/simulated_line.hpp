// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/haply_2diy/model_board.hpp"
#include "device/haply_2diy/serial_line.hpp"

#include <cstdint>
#include <deque>
#include <random>
#include <vector>

namespace tp {

/// What can go wrong on the way between a computer and a board. Shares are 0 … 1.
struct SerialTroubles {
    double drop_from_board = 0.0; ///< of all bytes
    double drop_to_board = 0.0;   ///< of all writes: one or two bytes of it, as an overrun loses them
    double garbage = 0.0;         ///< of all answers: some bytes are others
    double half = 0.0;            ///< of all answers: only a part of it comes
    bool half_write = false;      ///< the next write reaches the board only in part
    bool stall = false;           ///< nothing moves, all of it comes later
    bool mute = false;            ///< nothing comes from the board
    bool unplugged = false;
};

/// A serial line to a model board, in simulated time, with a delay and knobs for what goes wrong. The board
/// must outlive it.
class SimulatedLine final : public SerialLine {
public:
    /// `later_ms` is how many milliseconds after the next an answer comes.
    explicit SimulatedLine(ModelBoard& board, unsigned later_ms = 0, std::uint32_t seed = 1)
        : board_(board), later_ms_(later_ms), random_(seed) {}

    /// A millisecond of the board.
    void advance();
    /// A wait passes in simulated time too.
    int read(std::span<std::uint8_t> into, int wait_ms) noexcept override;
    bool write(std::span<const std::uint8_t> bytes) noexcept override;

    SerialTroubles troubles;

private:
    struct Late {
        std::uint64_t due = 0; ///< ms
        std::uint8_t byte = 0;
    };
    bool happens(double share);
    void take_answer();

    ModelBoard& board_;
    unsigned later_ms_;
    std::mt19937 random_;
    std::uint64_t now_ = 0; ///< ms
    std::deque<std::vector<std::uint8_t>> to_board_;
    std::deque<Late> from_board_;
};

} // namespace tp
