// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>

namespace tp {

/// A point or direction in a plane. The unit is the frame's: millimetres on the surface and in the device,
/// pixels in a photograph.
using Vec2 = glm::dvec2;

inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline bool is_finite(Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); }
inline double length(Vec2 v) { return std::hypot(v.x, v.y); }

/// Axis-aligned rectangle; empty where max < min.
struct Rect {
    Vec2 min{0.0};
    Vec2 max{0.0};

    double width() const { return max.x - min.x; }
    double height() const { return max.y - min.y; }
    Vec2 centre() const { return 0.5 * (min + max); }
    bool contains(Vec2 p) const { return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y; }
};

} // namespace tp
