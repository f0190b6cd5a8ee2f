// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/aim_cue.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

constexpr double glide_octaves = 0.25; ///< of a beep straight up, from its middle to its end, as the sonar's
constexpr double well_octaves = 0.5;   ///< by which the tone rises until the picture is taken

double hz_at(double octaves) { return level_hz * std::exp2(octaves); }

} // namespace

SonarCue aim_cue(const AimTone& tone, double waited) {
    if (tone.rising) {
        const double hz = hz_at(well_octaves * std::clamp(waited, 0.0, 1.0));
        return {0.0, hz, hz, line_gain * tone.gain, 0.0, 0.0};
    }
    if (tone.beats_per_s <= 0.0)
        return {0.0, level_hz, level_hz, line_gain * tone.gain, 0.0, 0.0};
    const double glide = glide_octaves * tone.pitch_octaves / highest_octaves;
    const double pitch = tone.pitch_octaves - glide; // the beep's end is the highest of all, as the sonar's
    return {1.0 / tone.beats_per_s, hz_at(pitch), hz_at(pitch + 2.0 * glide),
            beep_gain * tone.gain,  tone.side,    most_reed * std::max(0.0, -tone.side)};
}

} // namespace tp
