// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <QString>

#include <optional>

namespace tp {

/// How long a sentence takes to speak, seconds, at a voice's `rate` (-1 … 1, as Voice::set_rate). An estimate: 14
/// letters a second at the engine's own rate (about 150 words a minute), a Hangul syllable or other wide letter as
/// three, a doubling or halving at either end of the rates.
double speech_seconds(const QString& sentence, double rate = 0.0);

/// When the way to the nearest line is worth a word: when the finger rests, or drifts away from the line. Never before
/// the last word has been spoken, and never the same again to a finger that stays.
class ClockGuide {
public:
    static constexpr double rest_s = 0.5;
    static constexpr double rest_mm = 2.0;   ///< a finger that moves less rests
    static constexpr double drift_mm = 6.0;  ///< farther away than it has been since the last word

    /// What is to be said.
    struct Word {
        int hour = 12;       ///< 1 … 12
        int millimetres = 0; ///< to the line
        bool operator==(const Word&) const = default;
    };

    /// The finger is at `place` (mm) at `now` seconds, the nearest line `distance` mm away in direction `way`.
    std::optional<Word> follow(Vec2 place, double distance, Vec2 way, double now);
    /// Somebody speaks until then (seconds).
    void busy_until(double then);
    /// The finger is lifted: to the next one everything is new.
    void lift();

private:
    std::optional<Vec2> rests_at_;
    double rests_since_ = 0.0;
    double nearest_mm_ = 0.0; ///< since the last word
    std::optional<Word> said_;
    double busy_until_ = 0.0;
};

} // namespace tp
