// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/guide/cue_board.hpp"
#include "audio/sound/sound_source.hpp"

#include <atomic>

namespace tp {

/// Cues as samples. A beep keeps the cue that it began with; the wait for the next one follows the newest cue, so
/// that a finger that comes nearer hears it at once. Every change of loudness takes milliseconds: nothing clicks.
/// Goes on in silence for a while after the last cue, because a loudspeaker that is started anew is late; then it
/// ends.
class SonarStream final : public SoundSource {
public:
    /// The page's thread.
    CueBoard& board() { return board_; }
    /// It needs another stream. Any thread.
    bool ended() const { return ended_.load(); }

    std::size_t pull(std::span<float> samples) override;
    void heard(std::int64_t) override {}

private:
    struct Beep {
        SonarCue cue;
        int at = 0; ///< frames since it began
        double phase = 0.0;
    };
    double beep_sample();
    double steady_sample(const SonarCue& cue, bool wanted);

    CueBoard board_;
    std::atomic<bool> ended_{false};

    // Only the loudspeaker's thread.
    std::optional<Beep> beep_;
    std::int64_t since_beep_ = 1 << 30; ///< frames since the last one began
    double open_ = 0.0;                 ///< 0 silent … 1
    double steady_gain_ = 0.0;
    double steady_hz_ = level_hz;
    double steady_phase_ = 0.0;
    double side_ = 0.0; ///< of the steady tone, following its cue
    double reed_ = 0.0;
    std::int64_t silent_frames_ = 0;
};

} // namespace tp
