// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/scene.hpp"
#include "core/guidance/segment_tree.hpp"

#include <cmath>

namespace tp::testing {

/// The segments of a scene as ContourIndex orders them; each is owned by its contour's number.
inline SegmentSet set_of(const FlatScene& scene) {
    SegmentSet set;
    for (std::size_t c = 0; c < scene.lines.size(); ++c)
        for (std::size_t i = 0; i < scene.lines[c].segment_count(); ++i) {
            const Vec2 a = scene.lines[c].segment_start(i);
            const Vec2 b = scene.lines[c].segment_end(i);
            set.segments.emplace_back(a, b);
            set.owners.push_back(static_cast<int>(c));
            set.numbers.push_back(static_cast<std::uint32_t>(i));
            set.longest = std::max(set.longest, std::abs(b.x - a.x) + std::abs(b.y - a.y));
        }
    sort_along_hilbert_curve(set);
    return set;
}

/// In extended precision, by the perpendicular where its foot lies inside the segment, else by an end.
inline long double distance_to(const IndexedSegment& s, Vec2 p) {
    using Wide = long double;
    const Wide ux = Wide(s.b.x) - Wide(s.a.x), uy = Wide(s.b.y) - Wide(s.a.y);
    const Wide ax = Wide(p.x) - Wide(s.a.x), ay = Wide(p.y) - Wide(s.a.y);
    const Wide bx = Wide(p.x) - Wide(s.b.x), by = Wide(p.y) - Wide(s.b.y);
    if (ux * ax + uy * ay > 0 && ux * bx + uy * by < 0)
        return std::abs(ux * ay - uy * ax) / std::hypot(ux, uy);
    return std::min(std::hypot(ax, ay), std::hypot(bx, by));
}

/// What is nearest by asking all of them.
inline Closest<double> closest_of_all(const SegmentSet& set, Vec2 p) {
    Closest<double> closest;
    for (std::uint32_t i = 0; i < set.size(); ++i)
        closest.offer(set, i, p);
    return closest;
}

} // namespace tp::testing
