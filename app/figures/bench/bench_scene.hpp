// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/figures/report/hand_path.hpp"
#include "core/guidance/scene.hpp"

#include <string>
#include <vector>

namespace tp {

/// Half the side of the square surface on which everything is measured, mm.
constexpr double bench_half_side_mm = hand_half_side_mm;

/// Closed curves with `segments` segments in all on 200 × 200 mm, the same in every run.
struct BenchScene {
    std::string
        name; ///< "face" up to 2 000 segments: eyes, lips and outline; above, "map": curves of 200 segments
    std::size_t segments = 0;
    FlatScene flat;
};
BenchScene bench_scene(std::size_t segments);

/// Places all over the surface in no order.
std::vector<Vec2> random_places(std::size_t count);

} // namespace tp
