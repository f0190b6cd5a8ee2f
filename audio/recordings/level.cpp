// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/level.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace tp {

namespace {

constexpr int blocks_per_second = 20;
constexpr double full_scale = 32'768.0;

} // namespace

LevelMeter::LevelMeter(const SoundFormat& format)
    : format_(format), block_frames_(static_cast<std::size_t>(std::max(1, format.rate / blocks_per_second))),
      channels_(static_cast<std::size_t>(format.channels)) {}

void LevelMeter::add(std::span<const std::int16_t> samples) {
    for (std::size_t first = 0; first + channels_.size() <= samples.size(); first += channels_.size()) {
        for (std::size_t i = 0; i < channels_.size(); ++i) {
            const int sample = samples[first + i];
            channels_[i].sum += sample;
            channels_[i].squares += sample * sample;
            channels_[i].peak = std::max(channels_[i].peak, std::abs(sample));
        }
        if (++in_block_ == block_frames_)
            end_block();
    }
}

void LevelMeter::end_block() {
    const auto frames = static_cast<std::int64_t>(block_frames_);
    std::int64_t variance = 0; // times frames²
    int peak = 0;
    for (Channel& channel : channels_) {
        variance = std::max(variance, frames * channel.squares - channel.sum * channel.sum);
        peak = std::max(peak, channel.peak);
        channel = {};
    }
    in_block_ = 0;
    const double rms = std::sqrt(static_cast<double>(variance)) / static_cast<double>(frames);
    level_.rms_dbfs = 20.0 * std::log10(rms / full_scale * std::sqrt(2.0));
    level_.peak_dbfs = 20.0 * std::log10(peak / full_scale);
    quiet_frames_ = level_.rms_dbfs < quiet_dbfs ? quiet_frames_ + block_frames_ : 0;
    dead_frames_ = variance == 0 ? dead_frames_ + block_frames_ : 0;
}

bool LevelMeter::hears_nothing() const {
    return static_cast<double>(quiet_frames_) >= quiet_s * format_.rate ||
           static_cast<double>(dead_frames_) >= dead_s * format_.rate;
}

} // namespace tp
