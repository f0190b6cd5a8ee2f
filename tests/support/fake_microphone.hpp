// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/sound_format.hpp"
#include "audio/sound/sound_input.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tp::testing {

/// A microphone that hears what a test tells it to, with a knob for everything that goes wrong.
class FakeMicrophone final : public SoundInput {
public:
    bool there = true;
    int starts = 0;

    void start() override {
        ++starts;
        on_ = there;
        if (!there)
            emit lost(Trouble::none_there);
    }
    void stop() override { on_ = false; }
    bool on() const { return on_; }

    /// In blocks of 10 ms, as long as it is on.
    void hear(std::span<const float> samples) {
        std::vector<std::int16_t> block;
        while (!samples.empty() && on_) {
            block.resize(std::min<std::size_t>(samples.size(), sound_rate / 100));
            for (std::size_t i = 0; i < block.size(); ++i)
                block[i] = static_cast<std::int16_t>(std::lround(samples[i] * 32767.0F));
            samples = samples.subspan(block.size());
            emit this->block(block);
        }
    }
    void hear_nothing(double seconds) {
        hear(std::vector<float>(static_cast<std::size_t>(seconds * sound_rate)));
    }
    void vanish() {
        there = false;
        lose(Trouble::none_there);
    }
    void stall() { lose(Trouble::stalled); }
    void come() {
        there = true;
        emit came();
    }

private:
    void lose(Trouble trouble) {
        if (std::exchange(on_, false))
            emit lost(trouble);
    }

    bool on_ = false;
};

} // namespace tp::testing
