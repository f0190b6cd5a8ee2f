// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/sound_format.hpp"
#include "core/base/result.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>

namespace tp {

/// What recordings are brought to: ReplayGain 2.0's reference, and what AES TD1008 (2021) recommends for
/// speech.
constexpr double loudness_target_lufs = -18.0;
/// What no recording is amplified beyond (EBU R 128).
constexpr double highest_true_peak_dbtp = -1.0;
/// A recording that would need more holds more noise than voice.
constexpr double largest_gain_db = 24.0;

/// How loud a recording is as a whole (EBU R 128, ITU-R BS.1770-4). A mono recording counts as it is played,
/// from two loudspeakers.
struct Loudness {
    std::optional<double> integrated_lufs; ///< nothing: silence, or shorter than 0.4 s
    double true_peak_dbtp = 0.0;           ///< minus infinity for digital zeros

    /// What to add when playing, in dB, so that all recordings are equally loud and none is clipped: at most
    /// `largest_gain_db`; 0 where the loudness is not known.
    double gain_db() const;
};

/// Measures sound as it comes; its memory does not grow with the length.
class LoudnessMeter {
public:
    explicit LoudnessMeter(const SoundFormat& format);
    LoudnessMeter(LoudnessMeter&&) noexcept;
    LoudnessMeter& operator=(LoudnessMeter&&) = delete;
    ~LoudnessMeter();

    /// Whole frames, channel beside channel.
    void add(std::span<const std::int16_t> samples);
    /// The same with full scale ±2³¹.
    void add(std::span<const std::int32_t> samples);
    /// Of all that was added.
    Loudness loudness() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Of a whole sound file; reads it to its end. An error is the end of a sentence, also where less can be read
/// than the file claims.
Result<Loudness> loudness_of(const std::filesystem::path& file);

} // namespace tp
