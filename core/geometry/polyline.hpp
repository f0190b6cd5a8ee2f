// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <vector>

namespace tp {

/// Points joined by straight segments; a closed one does not repeat its first point.
struct Polyline {
    std::vector<Vec2> points;
    bool closed = false;

    std::size_t segment_count() const {
        return points.size() < 2 ? points.size() : points.size() - (closed ? 0u : 1u);
    }
    /// End points of segment `i` < segment_count(); a lone point is a segment of length zero.
    Vec2 segment_start(std::size_t i) const { return points[i]; }
    Vec2 segment_end(std::size_t i) const { return points[(i + 1) % points.size()]; }
};

/// The point of the segment a–b nearest to `p`, by clamped projection. Segments of length zero, or so short
/// that their squared length underflows, answer with `a`. Exact at both ends: returns `a` or `b` itself
/// there.
Vec2 nearest_on_segment(Vec2 a, Vec2 b, Vec2 p);

/// Distance from `p` to the nearest point of `line`; infinity for an empty line.
double distance_to(const Polyline& line, Vec2 p);

/// Length along the line, closing segment included.
double length_of(const Polyline& line);

/// The point `arc` along the line (same unit as the points), clamped to its ends; a closed line wraps round.
/// The line must have a point.
Vec2 point_along(const Polyline& line, double arc);

/// The arc length at which `line` passes nearest to `p`. The line must have a point.
double nearest_arc(const Polyline& line, Vec2 p);

/// `count` ≥ 2 points at equal arc lengths; an open line keeps both its ends. The line must have a point.
Polyline resampled(const Polyline& line, std::size_t count);

/// Bounding rectangle; {0,0}–{0,0} for no points.
Rect bounds_of(const std::vector<Vec2>& points);

} // namespace tp
