// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/contour.hpp"
#include "core/geometry/polyline.hpp"

namespace tp {

/// How closely straight segments follow a curve. A segment is fine enough when it keeps both bounds: polyline
/// facets are felt, and force shading shows them from 5° on (Morgenbesser & Srinivasan 1996).
struct FlattenTolerance {
    double chord = 0.01;        ///< largest distance from curve to segment, in the unit of the points; > 0
    double facet_degrees = 2.0; ///< largest turn of the curve within one segment; > 0
    int max_depth = 12;         ///< at most 2^max_depth segments a piece, whatever the bounds ask for
};

/// Adaptive subdivision of every piece. Joints are kept exactly; points that repeat their predecessor exactly
/// are dropped; pieces with a coordinate that is not finite are left out. Degenerate curves (all points
/// equal, cusps, loops, handles of any length) give finite points.
Polyline flatten(const Contour& contour, const FlattenTolerance& tolerance = {});

} // namespace tp
