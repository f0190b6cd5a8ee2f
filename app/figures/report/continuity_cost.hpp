// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/continuity.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace tp {

/// What a choice of Continuity buys and what it costs, beside the exact law on the reference face.
struct ContinuityCost {
    std::string manner; ///< exact, hold, blend, corner_cue, blend_and_corner_cue
    double width_mm = 0.0;
    double mean_error_n = 0.0; ///< of the force, along a hand's path within the band
    double p99_error_n = 0.0;
    double max_error_n = 0.0;
    double wrong_fraction = 0.0; ///< of that path, force off by more than a tenth of the peak
    double largest_step_n = 0.0; ///< change of the force in 0.1 mm of way
    double clicks_per_m = 0.0;   ///< changes of more than a quarter of the peak in 0.1 mm, a metre of way
    /// Switches a second of a finger that trembles (0.05 mm) half-way between two lines 6 mm apart.
    double tremor_clicks_per_s = 0.0;
    double work_given_mj = 0.0; ///< the most that one loop of 3 mm radius gives to the hand
};

struct ContinuityEffort {
    std::size_t samples = 400'000; ///< 0.1 mm of way each
    int loops = 2'000;
    double tremor_seconds = 20.0; ///< at 1 kHz
};

/// Every manner at the widths of interest. Seeded: the same figures every time.
std::vector<ContinuityCost> measure_continuity(const ContinuityEffort& effort = {});

} // namespace tp
