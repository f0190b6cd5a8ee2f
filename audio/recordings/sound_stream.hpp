// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/sound_format.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace tp {

/// How many bits of a sample carry sound; the highest of 32.
enum class SampleDepth { bits_8 = 8, bits_16 = 16, bits_24 = 24 };

/// Sound that is read from its beginning to its end.
class SoundStream {
public:
    virtual ~SoundStream() = default;
    virtual SoundFormat format() const = 0;
    virtual SampleDepth depth() const = 0;
    /// How many frames it has in all, as far as its header tells.
    virtual std::uint64_t frames() const = 0;
    /// Whole frames, channel beside channel, full scale ±2³¹ whatever the depth; how many frames there were.
    /// Fewer than asked: it ends there.
    virtual std::size_t read(std::span<std::int32_t> to) = 0;
};

/// Tells one sound from another: the same samples at the same depth, the same number (FNV-1a over samples).
class SoundFingerprint {
public:
    explicit SoundFingerprint(SampleDepth depth) : shift_(32 - static_cast<int>(depth)) {}

    void add(std::span<const std::int32_t> samples) {
        for (const std::int32_t sample : samples)
            hash_ = (hash_ ^ static_cast<std::uint32_t>(sample >> shift_)) * 0x100000001B3ull;
        samples_ += samples.size();
    }

    bool operator==(const SoundFingerprint&) const = default;

private:
    int shift_;
    std::uint64_t hash_ = 0xCBF29CE484222325ull;
    std::uint64_t samples_ = 0;
};

} // namespace tp
