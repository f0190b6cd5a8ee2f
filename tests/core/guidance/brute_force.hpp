// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/scene.hpp"

#include <algorithm>
#include <limits>
#include <random>

namespace tp::testing {

/// Distance in extended precision by another route than the index: the perpendicular where its foot lies
/// inside the segment, else an end.
inline long double true_distance(const FlatScene& scene, Vec2 p) {
    using Wide = long double;
    Wide best = std::numeric_limits<Wide>::infinity();
    for (const Polyline& line : scene.lines)
        for (std::size_t i = 0; i < line.segment_count(); ++i) {
            const Vec2 a = line.segment_start(i);
            const Vec2 b = line.segment_end(i);
            if (!is_finite(a) || !is_finite(b))
                continue;
            const Wide ux = Wide(b.x) - Wide(a.x), uy = Wide(b.y) - Wide(a.y);
            const Wide ax = Wide(p.x) - Wide(a.x), ay = Wide(p.y) - Wide(a.y);
            const Wide bx = Wide(p.x) - Wide(b.x), by = Wide(p.y) - Wide(b.y);
            best = std::min({best, std::hypot(ax, ay), std::hypot(bx, by)});
            if (ux * ax + uy * ay > 0 && ux * bx + uy * by < 0)
                best = std::min(best, std::abs(ux * ay - uy * ax) / std::hypot(ux, uy));
        }
    return best;
}

/// The same scene with its contours in another order, each drawn backwards.
inline FlatScene shuffled(const FlatScene& scene, std::mt19937& random) {
    std::vector<std::size_t> order(scene.lines.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    FlatScene result;
    for (const std::size_t i : order) {
        result.names.push_back(scene.names[i]);
        result.lines.push_back(scene.lines[i]);
        std::reverse(result.lines.back().points.begin(), result.lines.back().points.end());
    }
    return result;
}

} // namespace tp::testing
