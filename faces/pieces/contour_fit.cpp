// SPDX-License-Identifier: Apache-2.0
#include "faces/pieces/contour_fit.hpp"

#include <algorithm>

namespace tp {
namespace {

constexpr double most_uneven = 3.0; ///< ratio of neighbouring spans from which handles are shortened

struct Knot {
    Vec2 at{0.0};
    bool corner = false;
};

std::vector<Knot> knots_of(const std::vector<Vec2>& points, bool closed,
                           const std::vector<std::size_t>& corners) {
    std::vector<Knot> knots;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool corner = std::find(corners.begin(), corners.end(), i) != corners.end();
        if (!knots.empty() && knots.back().at == points[i])
            knots.back().corner |= corner;
        else
            knots.push_back({points[i], corner});
    }
    if (closed && knots.size() > 1 && knots.back().at == knots.front().at) {
        knots.front().corner |= knots.back().corner;
        knots.pop_back();
    }
    return knots;
}

/// Derivative by chord length at the middle one of three points, of the parabola through them.
Vec2 smooth_tangent(Vec2 before, Vec2 here, Vec2 after) {
    const double u = length(here - before), v = length(after - here);
    return (v * (here - before) / u + u * (after - here) / v) / (u + v);
}

/// Derivative at `here`, an end of the curve, of the parabola that leaves `next` with `tangent`.
Vec2 end_tangent(Vec2 here, Vec2 next, Vec2 tangent) {
    return 2.0 * (next - here) / length(next - here) - tangent;
}

} // namespace

Contour fit_contour(std::string name, const std::vector<Vec2>& points, bool closed,
                    const std::vector<std::size_t>& corners) {
    const std::vector<Knot> knots = knots_of(points, closed, corners);
    Contour contour{std::move(name), {}, closed};
    const std::size_t count = knots.size();
    if (count < 2)
        return contour;
    if (count == 2) {
        contour.pieces.emplace_back(Line{knots[0].at, knots[1].at});
        if (closed)
            contour.pieces.emplace_back(Line{knots[1].at, knots[0].at});
        return contour;
    }
    const auto breaks = [&](std::size_t i) {
        return knots[i].corner || (!closed && (i == 0 || i + 1 == count));
    };
    const auto tangent = [&](std::size_t i) {
        return smooth_tangent(knots[(i + count - 1) % count].at, knots[i].at, knots[(i + 1) % count].at);
    };
    // A long span beside a short one would swing out along that one's direction: its handles are kept short.
    const auto reach = [&](std::size_t i) {
        const double before = length(knots[i].at - knots[(i + count - 1) % count].at);
        const double after = length(knots[(i + 1) % count].at - knots[i].at);
        return most_uneven * std::min(before, after);
    };
    for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
        const std::size_t j = (i + 1) % count;
        const Vec2 a = knots[i].at, b = knots[j].at;
        if (breaks(i) && breaks(j)) {
            contour.pieces.emplace_back(Line{a, b});
            continue;
        }
        const Vec2 leaving = breaks(i) ? end_tangent(a, b, tangent(j)) : tangent(i);
        const Vec2 arriving = breaks(j) ? -end_tangent(b, a, -tangent(i)) : tangent(j);
        // A cubic's handles are a third of the span; those of its two quadratics are three quarters of that.
        const double span = 0.25 * length(b - a);
        const double from_a = std::min(span, 0.25 * reach(breaks(i) ? j : i));
        const double from_b = std::min(span, 0.25 * reach(breaks(j) ? i : j));
        const Vec2 first = a + from_a * leaving, second = b - from_b * arriving;
        const Vec2 middle = 0.5 * (first + second);
        contour.pieces.emplace_back(Quadratic{a, first, middle});
        contour.pieces.emplace_back(Quadratic{middle, second, b});
    }
    return contour;
}

std::vector<Vec2> uncrossed(std::vector<Vec2> points, std::size_t corner) {
    const Vec2 across = points[corner] - points[0];
    const auto opposite = [&](std::size_t i) { return points.size() - i; };
    const auto gap = [&](std::size_t i) { return cross(across, points[i] - points[opposite(i)]); };
    double opening = 0.0; // its sign says on which side the first edge belongs
    for (std::size_t i = 1; i < corner; ++i)
        opening += gap(i);
    for (std::size_t i = 1; i < corner; ++i)
        if (gap(i) * opening < 0.0)
            points[i] = points[opposite(i)] = 0.5 * (points[i] + points[opposite(i)]);
    return points;
}

} // namespace tp
