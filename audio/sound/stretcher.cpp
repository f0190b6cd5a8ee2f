// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/stretcher.hpp"

#include "audio/sound/sound_format.hpp"

#include <SoundTouch.h>
#include <algorithm>
#include <cmath>

namespace tp {

namespace {

// Lengths that suit speech (SoundTouch's README, "Tuning"); its defaults are for music.
constexpr int sequence_ms = 40;
constexpr int search_ms = 15;
constexpr int overlap_ms = 8;

} // namespace

struct Stretcher::Touch {
    soundtouch::SoundTouch engine;
};

Stretcher::Stretcher(int rate, int channels, double speed)
    : channels_(static_cast<std::size_t>(channels)),
      frames_due_for_one_(static_cast<double>(sound_rate) / rate / speed) {
    if (rate == sound_rate && speed == 1.0)
        return;
    touch_ = std::make_unique<Touch>();
    touch_->engine.setSampleRate(static_cast<unsigned>(rate));
    touch_->engine.setChannels(static_cast<unsigned>(channels));
    touch_->engine.setTempo(speed);
    touch_->engine.setRate(static_cast<double>(rate) / sound_rate);
    touch_->engine.setSetting(SETTING_SEQUENCE_MS, sequence_ms);
    touch_->engine.setSetting(SETTING_SEEKWINDOW_MS, search_ms);
    touch_->engine.setSetting(SETTING_OVERLAP_MS, overlap_ms);
}

Stretcher::~Stretcher() = default;

void Stretcher::put(std::span<const float> samples) {
    frames_due_ += static_cast<double>(samples.size() / channels_) * frames_due_for_one_;
    if (touch_)
        touch_->engine.putSamples(samples.data(), static_cast<unsigned>(samples.size() / channels_));
    else
        out_.insert(out_.end(), samples.begin(), samples.end());
}

void Stretcher::end() {
    if (touch_)
        touch_->engine.flush();
}

std::span<const float> Stretcher::take() {
    if (!touch_) {
        taken_.swap(out_);
        out_.clear();
        return taken_;
    }
    const double left = std::max(0.0, std::round(frames_due_) - frames_given_); // flush() may add silence
    const auto frames = std::min(touch_->engine.numSamples(), static_cast<unsigned>(left));
    taken_.resize(frames * channels_);
    frames_given_ += touch_->engine.receiveSamples(taken_.data(), frames);
    return taken_;
}

} // namespace tp
