// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <vector>

namespace tp {

/// Half the side of the square that the hand wanders over, mm; its middle is the origin.
constexpr double hand_half_side_mm = 100.0;

/// From one place of `hand_path` to the next, mm.
constexpr double hand_path_step_mm = 0.1;

/// A hand that wanders over the whole square. Seeded: always the same.
std::vector<Vec2> hand_path(std::size_t count);

} // namespace tp
