// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/earcon_stream.hpp"

#include "audio/sound/sound_format.hpp"

#include <algorithm>

namespace tp {

namespace {
constexpr std::size_t most_at_once = 4; // of −12 dBFS: together full scale
constexpr std::size_t patience_frames = 5 * sound_rate;
} // namespace

bool EarconStream::add(Earcon earcon) {
    const std::lock_guard lock(mutex_);
    if (!ended_ && (sounding_.size() < most_at_once || earcon == Earcon::fault))
        sounding_.push_back(samples_of(earcon));
    return !ended_;
}

std::size_t EarconStream::pull(std::span<float> samples) {
    const std::lock_guard lock(mutex_);
    silent_frames_ = sounding_.empty() ? silent_frames_ + samples.size() / played_channels : 0;
    ended_ = ended_ || silent_frames_ > patience_frames;
    if (ended_)
        return 0;
    std::ranges::fill(samples, 0.0F);
    for (std::span<const float>& sound : sounding_) {
        const std::size_t frames = std::min(sound.size(), samples.size() / played_channels);
        for (std::size_t i = 0; i < frames; ++i)
            for (std::size_t channel = 0; channel < played_channels; ++channel)
                samples[i * played_channels + channel] += sound[i];
        sound = sound.subspan(frames);
    }
    std::erase_if(sounding_, [](std::span<const float> sound) { return sound.empty(); });
    for (float& sample : samples)
        sample = std::clamp(sample, -1.0F, 1.0F);
    return samples.size();
}

} // namespace tp
