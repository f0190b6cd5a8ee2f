// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/published_law.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace tp {

namespace {

struct TwoNearest {
    std::size_t first = 0;
    std::size_t second = 0;
};

/// The square of how far a box is at least: as rounding keeps the order of numbers, it is at most the square
/// for any vertex in the box, as `two_nearest` computes it.
double squared_to(const Rect& box, Vec2 finger) noexcept {
    const Vec2 away = glm::max(glm::max(box.min - finger, finger - box.max), Vec2(0.0));
    return glm::dot(away, away);
}

/// Each of `boxes` bounds the next `together` vertices; what none bounds is looked at.
std::optional<TwoNearest> two_nearest(const std::vector<Vec2>& vertices, Vec2 finger,
                                      const std::vector<Rect>& boxes, std::size_t together) noexcept {
    if (vertices.size() < 2)
        return std::nullopt;
    const auto distance = [&](std::size_t i) { return glm::length(vertices[i] - finger); };
    const auto squared = [&](std::size_t i) { return glm::dot(vertices[i] - finger, vertices[i] - finger); };
    TwoNearest found{0, 1};
    double nearest = distance(0);
    double next = distance(1);
    if (next < nearest) {
        std::swap(found.first, found.second);
        std::swap(nearest, next);
    }
    double next_squared = squared(found.second);
    const auto look_at = [&](std::size_t from, std::size_t end) {
        for (std::size_t i = std::max(from, std::size_t(2)); i < end; ++i) {
            // Most are farther away, which the square tells without a root; roots of ordered numbers are ordered.
            if (squared(i) > next_squared)
                continue;
            const double now = distance(i);
            if (now < nearest) {
                found = {i, found.first};
                next = std::exchange(nearest, now);
            } else if (now < next) {
                found.second = i;
                next = now;
            }
            next_squared = squared(found.second);
        }
    };
    std::size_t from = 0;
    for (const Rect& box : boxes) {
        const std::size_t end = std::min(from + together, vertices.size());
        if (!(squared_to(box, finger) > next_squared))
            look_at(from, end);
        from = end;
    }
    look_at(from, vertices.size());
    return found;
}

struct Pull {
    Vec2 foot{0.0};
    double distance = 0.0;
    Vec2 force{0.0};
};

/// Lines 4 to 24 of the listing, for v1 and v2 already found: the tent is the same in both of its branches.
Pull pull_by_listing(Vec2 v1, Vec2 v2, const TentProfile& profile, Vec2 finger) noexcept {
    Pull pull;
    pull.foot = published_foot(v1, v2, finger);
    pull.distance = length(pull.foot - finger);
    const Vec2 direction = (pull.foot - finger) / pull.distance;
    const double r = pull.distance;
    const double d = profile.range;
    if (r <= d)
        pull.force = profile.stiffness * r * direction;
    else if (r <= 2.0 * d)
        pull.force = profile.stiffness * (2.0 * d - r) * direction;
    return pull;
}

} // namespace

Vec2 published_algorithm_1(const std::vector<Vec2>& vertices, const TentProfile& profile,
                           Vec2 finger) noexcept {
    const auto found = two_nearest(vertices, finger, {}, 1);
    return found ? pull_by_listing(vertices[found->first], vertices[found->second], profile, finger).force
                 : Vec2(0.0);
}

PublishedLaw::PublishedLaw(const FlatScene& scene, TentProfile profile, std::size_t together)
    : profile_(profile), together_(together) {
    for (std::size_t c = 0; c < scene.lines.size(); ++c)
        for (const Vec2 p : scene.lines[c].points)
            if (is_finite(p)) {
                vertices_.push_back(p);
                contours_.push_back(static_cast<int>(c));
            }
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        if (i % together_ == 0)
            boxes_.push_back({vertices_[i], vertices_[i]});
        boxes_.back() = {glm::min(boxes_.back().min, vertices_[i]),
                         glm::max(boxes_.back().max, vertices_[i])};
    }
}

Guidance PublishedLaw::at(Vec2 finger) const noexcept {
    const auto found = two_nearest(vertices_, finger, boxes_, together_);
    if (!found || !is_finite(finger))
        return {};
    const Vec2 v1 = vertices_[found->first];
    const Pull pull = pull_by_listing(v1, vertices_[found->second], profile_, finger);
    return {.force = is_finite(pull.force) ? pull.force : Vec2(0.0),
            .distance = pull.distance,
            .nearest = pull.foot,
            .contour = contours_[found->first]};
}

FlatScene with_vertex_spacing(const FlatScene& scene, double spacing_mm) {
    FlatScene result{scene.names, {}};
    for (const Polyline& line : scene.lines) {
        const double gaps = std::ceil(length_of(line) / spacing_mm);
        const auto count = static_cast<std::size_t>(std::max(2.0, gaps + (line.closed ? 0.0 : 1.0)));
        result.lines.push_back(line.points.empty() ? line : resampled(line, count));
    }
    return result;
}

} // namespace tp
