// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/spacing.hpp"

#include <algorithm>
#include <limits>

namespace tp {

namespace {

struct Gap {
    double distance = std::numeric_limits<double>::infinity();
    Vec2 where{0.0};
};

bool cross_over(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const double c_side = cross(b - a, c - a);
    const double d_side = cross(b - a, d - a);
    const double a_side = cross(d - c, a - c);
    const double b_side = cross(d - c, b - c);
    return ((c_side > 0.0) != (d_side > 0.0)) && ((a_side > 0.0) != (b_side > 0.0));
}

/// Two segments that do not cross are nearest at an end of one of them.
void narrow(Gap& gap, Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    if (cross_over(a, b, c, d)) {
        const double share = cross(c - a, d - c) / cross(b - a, d - c);
        gap = {0.0, a + share * (b - a)};
        return;
    }
    const auto try_pair = [&](Vec2 on_first, Vec2 on_second) {
        const double distance = length(on_first - on_second);
        if (distance < gap.distance)
            gap = {distance, on_first};
    };
    try_pair(a, nearest_on_segment(c, d, a));
    try_pair(b, nearest_on_segment(c, d, b));
    try_pair(nearest_on_segment(a, b, c), c);
    try_pair(nearest_on_segment(a, b, d), d);
}

/// The largest distance along one axis between two boxes; no two points of theirs are nearer.
double box_gap(const Rect& a, const Rect& b) {
    const Vec2 apart = glm::max(a.min - b.max, b.min - a.max);
    return std::max(apart.x, apart.y);
}

Gap gap_between(const Polyline& first, const Polyline& second, double reach) {
    Gap gap;
    for (std::size_t i = 0; i < first.segment_count() && gap.distance > 0.0; ++i) {
        const Vec2 a = first.segment_start(i);
        const Vec2 b = first.segment_end(i);
        const Rect box{glm::min(a, b), glm::max(a, b)};
        for (std::size_t k = 0; k < second.segment_count() && gap.distance > 0.0; ++k) {
            const Vec2 c = second.segment_start(k);
            const Vec2 d = second.segment_end(k);
            if (box_gap(box, {glm::min(c, d), glm::max(c, d)}) < std::min(reach, gap.distance))
                narrow(gap, a, b, c, d);
        }
    }
    return gap;
}

/// The two points of a closed line that are farthest apart: its ends, if it is a shut eye or mouth.
std::pair<std::size_t, std::size_t> farthest_pair(const std::vector<Vec2>& points) {
    std::pair<std::size_t, std::size_t> best{0, 0};
    double farthest = -1.0;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = i + 1; k < points.size(); ++k)
            if (const double distance = length(points[i] - points[k]); distance > farthest) {
                farthest = distance;
                best = {i, k};
            }
    return best;
}

} // namespace

std::vector<Closeness> closeness(const FlatScene& scene, const TentProfile& profile) {
    std::vector<Closeness> pairs;
    for (std::size_t i = 0; i < scene.lines.size(); ++i)
        for (std::size_t k = i + 1; k < scene.lines.size(); ++k) {
            const Gap gap = gap_between(scene.lines[i], scene.lines[k], profile.band());
            if (gap.distance < profile.band())
                pairs.push_back({static_cast<int>(i), static_cast<int>(k), gap.distance, gap.where,
                                 std::min(profile.stiffness * gap.distance / 2.0, profile.peak()),
                                 gap.distance >= tellable_gap_mm});
        }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Closeness& a, const Closeness& b) { return a.gap < b.gap; });
    return pairs;
}

std::optional<TentProfile> proposed_profile(const std::vector<Closeness>& pairs, const TentProfile& profile) {
    constexpr double shortest_range_mm = 2.0;
    constexpr double stiffest_n_per_mm = 0.5;
    const auto narrowest =
        std::find_if(pairs.begin(), pairs.end(), [](const Closeness& pair) { return pair.tellable; });
    if (narrowest == pairs.end())
        return std::nullopt;
    const double range = std::max(0.25 * narrowest->gap, shortest_range_mm);
    if (!(range < profile.range))
        return std::nullopt;
    const double stiffness = std::min(profile.peak() / range, std::max(stiffest_n_per_mm, profile.stiffness));
    return TentProfile{stiffness, range};
}

std::optional<Contour> thinned(const Contour& contour, double gap) {
    if (!contour.closed)
        return std::nullopt;
    const Polyline line = flatten(contour, {0.02, 5.0});
    if (line.points.size() < 3 || !std::isfinite(length_of(line)))
        return std::nullopt;
    const Polyline even =
        resampled(line, std::min<std::size_t>(400, std::max<std::size_t>(40, line.points.size())));
    const auto [from, to] = farthest_pair(even.points);
    Polyline there{{}, false};
    Polyline back{{}, false};
    for (std::size_t i = from; i <= to; ++i)
        there.points.push_back(even.points[i]);
    for (std::size_t i = from + even.points.size(); i >= to; --i)
        back.points.push_back(even.points[i % even.points.size()]);
    for (const Polyline* side : {&there, &back})
        for (const Vec2 p : side->points)
            if (distance_to(side == &there ? back : there, p) >= gap)
                return std::nullopt;
    constexpr std::size_t count = 40;
    const Polyline one = resampled(there, count);
    const Polyline other = resampled(back, count);
    std::vector<Vec2> middle;
    for (std::size_t i = 0; i < count; ++i)
        middle.push_back(0.5 * one.points[i] + 0.5 * other.points[i]); // a sum may be too large for a double
    return contour_through(contour.name, middle, false);
}

} // namespace tp
