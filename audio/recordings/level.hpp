// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/sound_format.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace tp {

/// How strong the sound of a moment is, in dBFS: 0 is a sine of full scale, for the RMS too (AES17). Of the
/// louder channel. Digital zero is minus infinity.
struct Level {
    double rms_dbfs =
        -std::numeric_limits<double>::infinity(); ///< without a constant part, which nobody hears
    double peak_dbfs = -std::numeric_limits<double>::infinity();
};

/// Below this a microphone hears nothing, not even a room. dBFS, RMS.
constexpr double quiet_dbfs = -60.0;
constexpr double quiet_s = 3.0; ///< so long until it is said
/// The same for samples that do not change at all: no microphone is that quiet, so it is muted or unplugged.
constexpr double dead_s = 1.0;

/// Level of sound as it comes, and whether there is any; in the time of the sound, not of a clock, and the
/// same however the sound is cut into pieces.
class LevelMeter {
public:
    explicit LevelMeter(const SoundFormat& format);

    /// Whole frames, channel beside channel.
    void add(std::span<const std::int16_t> samples);
    /// Of the last whole block of 50 ms; digital zero before the first.
    Level level() const { return level_; }
    /// True as long as the sound has been quiet for `quiet_s`, or constant for `dead_s`.
    bool hears_nothing() const;

private:
    struct Channel {
        std::int64_t sum = 0;
        std::int64_t squares = 0;
        int peak = 0;
    };
    void end_block();

    SoundFormat format_;
    std::size_t block_frames_;
    std::vector<Channel> channels_;
    std::size_t in_block_ = 0; ///< frames
    Level level_;
    std::uint64_t quiet_frames_ = 0;
    std::uint64_t dead_frames_ = 0;
};

} // namespace tp
