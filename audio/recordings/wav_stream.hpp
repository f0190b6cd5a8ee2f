// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/sound_stream.hpp"
#include "audio/recordings/wav_layout.hpp"

#include <vector>

namespace tp {

/// The samples of a recording that is not finished.
class WavStream : public SoundStream {
public:
    WavStream(const ByteSource& file, const WavLayout& layout) : file_(file), layout_(layout) {}

    SoundFormat format() const override { return layout_.format; }
    SampleDepth depth() const override { return SampleDepth::bits_16; }
    std::uint64_t frames() const override { return layout_.frames; }
    std::size_t read(std::span<std::int32_t> to) override;

private:
    const ByteSource& file_;
    const WavLayout& layout_;
    std::uint64_t next_ = 0;
    std::vector<std::int16_t> block_;
};

} // namespace tp
