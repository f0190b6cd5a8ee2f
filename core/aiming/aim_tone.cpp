// SPDX-License-Identifier: Apache-2.0
#include "core/aiming/aim_tone.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

AimTone aim_tone(const Adviser& adviser, HeldCamera camera, bool speaking) {
    if (!adviser.framing())
        return {};
    const Framing& framing = *adviser.framing();
    AimTone tone;
    tone.sounds = true;
    tone.gain = speaking ? gain_under_words : 1.0;
    tone.rising = adviser.good();
    if (!adviser.there(AimFault::across) && !adviser.there(AimFault::height))
        return tone;
    const Vec2 off = framing.off / framing.tolerance;
    const double distance = length(off);
    if (!std::isfinite(distance) || distance <= 0.0)
        return tone;
    const Vec2 way = camera.hand_way(off) / distance;
    const double share = std::clamp((distance - 1.0) / (far_off - 1.0), 0.0, 1.0);
    // The time between beats grows with the distance, not their rate (audio/guide).
    tone.beats_per_s = 1.0 / (1.0 / fastest_beats + share * (1.0 / slowest_beats - 1.0 / fastest_beats));
    tone.pitch_octaves = highest_octaves * way.y;
    tone.side = way.x;
    return tone;
}

} // namespace tp
