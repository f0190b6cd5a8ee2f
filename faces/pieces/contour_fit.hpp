// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/contour.hpp"

#include <string>
#include <vector>

namespace tp {

/// A smooth curve through points: chordal Catmull-Rom tangents, each cubic span as two quadratic Béziers;
/// long spans beside short ones are kept from swinging out. Passes through every point; the direction is
/// continuous (G1) everywhere except at `corners` (indices into `points`) and at the ends of an open curve.
/// Points that repeat their predecessor are skipped; two points that remain give a line, one or none an empty
/// contour. Points must be finite.
Contour fit_contour(std::string name, const std::vector<Vec2>& points, bool closed,
                    const std::vector<std::size_t>& corners = {});

/// Points around an opening: [0] one corner, [corner] the other, one edge between them and the other edge
/// after. Where the edges have changed sides, as noise makes them on shut lips and lids, both are put midway.
/// Both edges must have as many points.
std::vector<Vec2> uncrossed(std::vector<Vec2> points, std::size_t corner);

} // namespace tp
