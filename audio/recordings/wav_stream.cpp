// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/wav_stream.hpp"

#include <algorithm>

namespace tp {

std::size_t WavStream::read(std::span<std::int32_t> to) {
    block_.resize(to.size());
    const std::size_t frames = read_frames(file_, layout_, next_, block_);
    next_ += frames;
    const std::size_t samples = frames * static_cast<std::size_t>(layout_.format.channels);
    std::transform(block_.begin(), block_.begin() + static_cast<std::ptrdiff_t>(samples), to.begin(),
                   [](std::int16_t sample) { return static_cast<std::int32_t>(sample) * 65'536; });
    return frames;
}

} // namespace tp
