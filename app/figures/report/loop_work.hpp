// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/haptic_scene.hpp"

#include <string>
#include <vector>

namespace tp {

/// How far a law is from the force that the contours ask for, and how much work it does round closed loops.
struct LoopWork {
    std::string law;
    double vertex_spacing_mm = 0.0;
    double wrong_fraction = 0.0;  ///< of random places, force off by more than a tenth of the peak
    double wrong_of_pulled = 0.0; ///< the same of the places that this law or the truth pulls from
    double max_force_error_n = 0.0;
    double max_loop_work_mj = 0.0; ///< over circles of 3 mm radius; 0 for a conservative field
    double p99_loop_work_mj = 0.0; ///< of 99 loops in a hundred; the largest grows with the number of loops
    double max_force_step_n = 0.0; ///< largest change of the force between places 0.01 mm apart on the loops
};

struct LoopWorkEffort {
    int points = 200'000;
    int loops = 2'000;
    int steps_per_loop = 1'885; ///< 0.01 mm apart; halved where the force jumps
};

/// Both laws on the reference face cut into vertices `spacing` mm apart. The truth is the tent over the true
/// distance to the same polylines. Random places are seeded: the same figures every time.
std::vector<LoopWork> measure_loop_work(const std::vector<double>& spacings_mm,
                                        const LoopWorkEffort& effort = {});

} // namespace tp
