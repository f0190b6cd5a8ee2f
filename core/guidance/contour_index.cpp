// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/contour_index.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace tp {

namespace {

/// Place of each name in the alphabet; equal names share one.
std::vector<int> ranks_of(const std::vector<std::string>& names) {
    std::vector<std::string> sorted = names;
    std::sort(sorted.begin(), sorted.end());
    std::vector<int> ranks;
    ranks.reserve(names.size());
    for (const std::string& name : names)
        ranks.push_back(
            static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), name) - sorted.begin()));
    return ranks;
}

bool before(Vec2 a, Vec2 b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }

} // namespace

ContourIndex::ContourIndex(const FlatScene& scene) {
    const std::vector<int> ranks = ranks_of(scene.names);
    for (std::size_t c = 0; c < scene.lines.size(); ++c) {
        const Polyline& line = scene.lines[c];
        for (std::size_t i = 0; i < line.segment_count(); ++i) {
            Vec2 a = line.segment_start(i);
            Vec2 b = line.segment_end(i);
            if (!is_finite(a) || !is_finite(b))
                continue;
            if (before(b, a))
                std::swap(a, b);
            segments_.push_back({a, b, static_cast<int>(c), ranks[c]});
        }
    }
}

template <typename Measure>
Nearest ContourIndex::scan(Vec2 p, Measure measure) const noexcept {
    Nearest best;
    double best_measure = std::numeric_limits<double>::infinity();
    int best_rank = 0;
    for (const Segment& segment : segments_) {
        const Vec2 q = nearest_on_segment(segment.a, segment.b, p);
        const double here = measure(p - q);
        if (here < best_measure || (here == best_measure && std::tie(q.x, q.y, segment.name_rank) <
                                                               std::tie(best.point.x, best.point.y, best_rank))) {
            best_measure = here;
            best_rank = segment.name_rank;
            best.point = q;
            best.contour = segment.contour;
        }
    }
    if (best.found())
        best.distance = length(p - best.point);
    return best;
}

Nearest ContourIndex::nearest(Vec2 p) const noexcept {
    if (!is_finite(p))
        return {};
    const Nearest best = scan(p, [](Vec2 v) { return glm::dot(v, v); });
    // Squares overflow beyond 1e154 mm and lose their digits below 1e-145 mm; hypot does neither, but is slow.
    if (best.distance < 1e150 && (best.distance > 1e-140 || best.distance == 0.0))
        return best;
    return scan(p, [](Vec2 v) { return length(v); });
}

} // namespace tp
