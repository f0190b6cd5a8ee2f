// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/sample_ring.hpp"
#include "audio/sound/sound_file.hpp"
#include "audio/sound/sound_source.hpp"
#include "audio/sound/stretcher.hpp"

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// One recording from one place on at one speed, on its way from the disk to the loudspeaker. Three threads
/// meet in it: the one that decodes (open, fill), the output's (pull, heard), and the owner's (the rest).
/// None waits for another.
class PlaybackStream final : public SoundSource {
public:
    struct What {
        std::filesystem::path file;
        double begin_s = 0.0;
        double speed = 1.0; ///< 0.5–2
        double gain_db = 0.0;
        double silence_s = 0.0; ///< before it begins
    };
    explicit PlaybackStream(What what);

    // The decoding thread's.
    /// The sentence that says why it cannot be played; empty when it can. Before everything else.
    std::string open();
    /// Decodes until the buffer is full or the recording has ended; false where nothing is left to decode.
    bool fill();

    // The output's thread's.
    /// A disk that is too slow is heard as silence, not as an end.
    std::size_t pull(std::span<float> samples) override;
    void heard(std::int64_t frames) override;

    // The owner's thread's; valid once open() has returned.
    double duration_s() const { return duration_s_; }
    /// What is being heard now, in the recording's own seconds.
    double position_s() const;
    /// The silence before it is over.
    bool begun() const { return begun_.load(std::memory_order_relaxed); }
    /// How much of the buffer is filled, 0–1.
    double buffered() const;

private:
    void give(std::span<const float> samples);

    const What what_;
    const std::int64_t silence_frames_;
    const float gain_;
    double duration_s_ = 0.0;
    std::optional<SoundFile> file_;
    std::optional<Stretcher> stretcher_;
    std::vector<float> waiting_; ///< decoded, two channels, for which the ring had no room
    bool all_read_ = false;

    SampleRing ring_;
    std::atomic<bool> all_given_{false}; ///< everything is in the ring
    std::int64_t silence_left_;          ///< the output's
    std::int64_t starved_ = 0;           ///< the output's: frames for which the decoding thread came too late
    std::atomic<bool> begun_{false};
    std::atomic<std::int64_t> sounded_{0}; ///< frames of the recording that were heard
};

} // namespace tp
