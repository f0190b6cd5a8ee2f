// SPDX-License-Identifier: Apache-2.0
#include "audio/guide/sonar_cue.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

constexpr double half_range_octaves = 0.5;  ///< from a line beside to one straight above
constexpr double half_glide_octaves = 0.25; ///< from a beep's middle to its end

double octaves_from_level(double octaves) { return level_hz * std::exp2(octaves); }
double between(double from, double to, double share) { return from + share * (to - from); }

} // namespace

SonarCue sonar_cue(double distance_mm, double right, double up) {
    const double distance = std::isfinite(distance_mm) ? std::max(0.0, distance_mm) : far_mm;
    const double way = std::hypot(right, up);
    const bool directed = std::isfinite(way) && way > 0.0;
    const double side = directed ? right / way : 0.0;
    if (distance <= on_line_mm)
        return {0.0, level_hz, level_hz, line_gain, 0.0, 0.0};
    const double height = directed ? up / way : 0.0;
    const double share = std::min(1.0, (distance - on_line_mm) / (far_mm - on_line_mm));
    return {between(shortest_interval_s, longest_interval_s, share),
            octaves_from_level((half_range_octaves - half_glide_octaves) * height),
            octaves_from_level((half_range_octaves + half_glide_octaves) * height),
            between(beep_gain, far_gain, share),
            side,
            most_reed * std::max(0.0, -side)};
}

SonarCue tour_cue(double across, double height) {
    const double x = std::isfinite(across) ? std::clamp(across, 0.0, 1.0) : 0.5;
    const double y = std::isfinite(height) ? std::clamp(height, 0.0, 1.0) : 0.5;
    const double hz = octaves_from_level(2.0 * y - 1.0);
    return {0.0, hz, hz, 0.5 * beep_gain, 2.0 * x - 1.0, most_reed * std::max(0.0, 1.0 - 2.0 * x)};
}

} // namespace tp
