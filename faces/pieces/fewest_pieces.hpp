// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/contour.hpp"

#include <string>
#include <vector>

namespace tp {

/// The smooth curve through points that fit_contour draws, with as few lines and quadratic Béziers as stay
/// within `tolerance` (unit of the points, > 0) of it, compared at 16 places a piece (between them up to 10 %
/// more). Joints are a choice of the points (the best one, by dynamic programming) and keep the curve's
/// direction there (G1), corners and ends of an open curve stay where they are. Between two joints lies one
/// quadratic, whose control point the two directions give, or two that meet where the direction turns the
/// other way. Points must be finite; few points and repeated ones as in fit_contour.
Contour fewest_pieces(std::string name, const std::vector<Vec2>& points, bool closed,
                      const std::vector<std::size_t>& corners, double tolerance);

} // namespace tp
