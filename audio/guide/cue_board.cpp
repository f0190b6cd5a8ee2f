// SPDX-License-Identifier: Apache-2.0
#include "audio/guide/cue_board.hpp"

namespace tp {

void CueBoard::write(const SonarCue& cue, bool sounds) {
    const std::uint64_t version = version_.load(std::memory_order_relaxed);
    version_.store(version + 1, std::memory_order_relaxed);
    const std::array values{cue.interval_s, cue.from_hz, cue.to_hz, cue.gain, cue.side, cue.reed};
    for (std::size_t i = 0; i < values.size(); ++i) // each release keeps the odd version before it
        values_[i].store(values[i], std::memory_order_release);
    sounds_.store(sounds, std::memory_order_release);
    version_.store(version + 2, std::memory_order_release);
}

std::optional<SonarCue> CueBoard::read() {
    const std::uint64_t before = version_.load(std::memory_order_acquire);
    std::array<double, 6> values{};
    for (std::size_t i = 0; i < values.size(); ++i) // each acquire keeps the second look behind it
        values[i] = values_[i].load(std::memory_order_acquire);
    const bool sounds = sounds_.load(std::memory_order_acquire);
    const bool whole = before % 2 == 0 && before == version_.load(std::memory_order_relaxed);
    if (whole && sounds)
        last_ = SonarCue{values[0], values[1], values[2], values[3], values[4], values[5]};
    else if (whole)
        last_.reset();
    return last_;
}

} // namespace tp
