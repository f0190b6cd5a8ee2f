// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <vector>

namespace tp {

/// Half the side of the square that the hand wanders over, mm; its middle is the origin.
constexpr double hand_half_side_mm = 100.0;

/// A hand that wanders over the whole square, 0.1 mm from sample to sample. Seeded: always the same.
std::vector<Vec2> hand_path(std::size_t count);

} // namespace tp
