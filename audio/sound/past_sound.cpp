// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/past_sound.hpp"

#include <algorithm>

namespace tp {

void PastSound::add(std::span<const std::int16_t> samples) {
    samples = samples.last(std::min(samples.size(), samples_.size()));
    for (const std::int16_t sample : samples) {
        samples_[next_] = sample;
        next_ = (next_ + 1) % samples_.size();
    }
    count_ = std::min(count_ + samples.size(), samples_.size());
}

std::vector<std::int16_t> PastSound::all() const {
    std::vector<std::int16_t> past;
    past.reserve(count_);
    const std::size_t oldest = (next_ + samples_.size() - count_) % samples_.size();
    for (std::size_t i = 0; i < count_; ++i)
        past.push_back(samples_[(oldest + i) % samples_.size()]);
    return past;
}

} // namespace tp
