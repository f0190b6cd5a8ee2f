// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/aim_pulses.hpp"

#include <algorithm>
#include <utility>

namespace tp {

std::optional<double> AimPulses::due(const AimTone& tone, double now_s) {
    if (!tone.sounds) {
        forget();
        return std::nullopt;
    }
    const bool was_well = std::exchange(well_, tone.rising);
    if (tone.rising)
        return was_well ? std::nullopt : std::optional(well_pulse);
    if (tone.beats_per_s <= 0.0) // at its place, and something else is wrong
        return std::nullopt;
    const double interval_s = 1.0 / tone.beats_per_s;
    if (last_s_ && now_s >= *last_s_ && now_s - *last_s_ < interval_s)
        return std::nullopt;
    last_s_ = now_s;
    constexpr double slowest_s = 1.0 / slowest_beats, fastest_s = 1.0 / fastest_beats;
    const double near = std::clamp((slowest_s - interval_s) / (slowest_s - fastest_s), 0.0, 1.0);
    return farthest_pulse + near * (nearest_pulse - farthest_pulse);
}

} // namespace tp
