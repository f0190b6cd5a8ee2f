// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace tp {

/// What a SoundOutput plays. Its thread is the output's; the output keeps it alive by sharing it, so that one
/// that was stopped may still be asked for a moment. Never waits for anything.
class SoundSource {
public:
    virtual ~SoundSource() = default;

    /// Fills `samples` (interleaved, ±1) and returns how many it filled: all of them, unless the sound ends
    /// there. After an end only 0.
    virtual std::size_t pull(std::span<float> samples) = 0;

    /// It answers a finger, so that an output should ask for it as little ahead of the ear as it can.
    virtual bool answers_a_finger() const { return false; }

    /// So many frames of what was pulled have left the loudspeaker.
    virtual void heard(std::int64_t frames) = 0;
};

} // namespace tp
