// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aiming/adviser.hpp"

namespace tp {

inline constexpr double fastest_beats = 10.0;  ///< a second: beside the place, as the sonar's on a line
inline constexpr double slowest_beats = 1.25;  ///< a second: far off it
inline constexpr double far_off = 5.0;         ///< times the tolerance: the beats slow down no further
inline constexpr double highest_octaves = 0.5; ///< above the middle pitch, of a way straight up
inline constexpr double gain_under_words = 0.35;

/// Where the camera is to be moved, as numbers for a tone; whoever has a loudspeaker makes the sound. It is the sonar's
/// language (audio/guide): the nearer the faster, up is high, right is right.
struct AimTone {
    bool sounds = false;
    double beats_per_s = 0.0;   ///< 0: one steady tone
    double pitch_octaves = 0.0; ///< above the middle pitch
    double side = 0.0;          ///< -1 left … 1 right, of the person
    double gain = 1.0;          ///< 0 … 1 of its usual loudness; less under words
    bool rising = false;        ///< all is well: it rises while one waits for the picture
    bool operator==(const AimTone&) const = default;
};

/// `adviser` has seen the frame; silence where it saw nobody. `speaking`: words are heard at the same time.
AimTone aim_tone(const Adviser& adviser, HeldCamera camera, bool speaking);

} // namespace tp
