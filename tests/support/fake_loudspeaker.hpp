// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/sound_format.hpp"
#include "audio/sound/sound_output.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace tp::testing {

/// A loudspeaker whose time a test moves by hand, with a knob for everything that goes wrong.
class FakeLoudspeaker final : public SoundOutput {
public:
    bool there = true;
    std::int64_t late_frames = 0; ///< pulled so long before they are heard
    std::vector<float> heard;     ///< everything, left channel
    std::vector<quint64> runs;    ///< everything that was started

    void start(quint64 run, std::shared_ptr<SoundSource> source) override {
        stop();
        runs.push_back(run);
        if (!there) {
            emit gone(run);
            return;
        }
        run_ = run;
        source_ = std::move(source);
    }
    void stop() override { source_.reset(); }

    bool playing() const { return source_ != nullptr; }

    /// Lets so much time pass, in steps of 10 ms. Silence counts as heard, too.
    void play(double seconds) {
        for (auto steps = static_cast<int>(seconds * 100.0 + 0.5); steps > 0; --steps)
            step();
    }
    void vanish() {
        there = false;
        if (std::exchange(source_, nullptr) != nullptr)
            emit gone(run_);
    }
    void come() {
        there = true;
        emit came();
    }
    void move() {
        if (std::exchange(source_, nullptr) != nullptr)
            emit moved(run_);
    }

private:
    void step() {
        constexpr std::size_t frames = sound_rate / 100;
        std::array<float, frames * played_channels> block{};
        if (source_ == nullptr) {
            heard.insert(heard.end(), frames, 0.0F);
            return;
        }
        if (pulled_for_ != run_) {
            pulled_for_ = run_;
            pulled_ = 0;
            told_ = 0;
        }
        const std::size_t got = source_->pull(block) / played_channels;
        pulled_ += static_cast<std::int64_t>(got);
        for (std::size_t i = 0; i < frames; ++i)
            heard.push_back(i < got ? block[i * played_channels] : 0.0F);
        const bool over = got == 0 && told_ + static_cast<std::int64_t>(frames) >= pulled_;
        told_ = over ? pulled_
                     : std::min(pulled_, std::max(told_ + (got == 0 ? static_cast<std::int64_t>(frames) : 0),
                                                  pulled_ - late_frames));
        const quint64 run = run_;
        source_->heard(told_);
        emit progress(run);
        if (over && source_ != nullptr && run == run_) {
            source_.reset();
            emit drained(run);
        }
    }

    quint64 run_ = 0;
    quint64 pulled_for_ = 0;
    std::int64_t pulled_ = 0;
    std::int64_t told_ = 0;
    std::shared_ptr<SoundSource> source_;
};

} // namespace tp::testing
