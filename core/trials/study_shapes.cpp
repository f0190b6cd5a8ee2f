// SPDX-License-Identifier: Apache-2.0
#include "core/trials/study_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace tp {
namespace {

constexpr std::array<std::string_view, 8> names{"circle",  "triangle", "square", "pentagon",
                                                "hexagon", "curve",    "line",   "broken-line"};

Vec2 at_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }

Contour circle(Vec2 centre, double radius, double first) {
    constexpr double handle = 0.5522847498307936; // of a quarter, 4/3·(√2 − 1)
    Contour contour{"circle", {}, true};
    const Vec2 begin = at_angle(2.0 * std::numbers::pi * first);
    Vec2 from = begin;
    for (int quarter = 0; quarter < 4; ++quarter) {
        const Vec2 to = quarter == 3 ? begin : Vec2(-from.y, from.x);
        contour.pieces.emplace_back(Cubic{centre + radius * from, centre + radius * (from + handle * to),
                                          centre + radius * (to + handle * from), centre + radius * to});
        from = to;
    }
    return contour;
}

Contour polygon(StudyShape shape, Vec2 centre, double radius, double first) {
    const int corners = 2 + static_cast<int>(shape);
    std::vector<Vec2> points;
    for (int i = 0; i < corners; ++i) {
        const double turn = (std::fmod(first, corners) + i + 0.5) / corners;
        points.push_back(centre + radius * at_angle(2.0 * std::numbers::pi * turn - 0.5 * std::numbers::pi));
    }
    return contour_through(std::string(names[static_cast<std::size_t>(shape)]), points, true);
}

Contour curve(Vec2 centre, double radius, double first) {
    const auto place = [&](double x, double y) { return centre + radius * Vec2(x, y); };
    const Vec2 left = place(-1.0, 0.0), right = place(1.0, 0.0);
    Cubic one{left, place(-0.66, 0.5), place(-0.34, 0.5), centre};
    Cubic other{centre, place(0.34, -0.5), place(0.66, -0.5), right};
    if (std::fmod(first, 2.0) >= 1.0) {
        std::swap(one, other);
        for (Cubic* const piece : {&one, &other}) {
            std::swap(piece->a, piece->b);
            std::swap(piece->control_a, piece->control_b);
        }
    }
    return {"curve", {one, other}, false};
}

/// From the left to the right; the broken one by a corner of 90° above the middle.
Contour line(StudyShape shape, Vec2 centre, double radius, double first) {
    std::vector<Vec2> points{{-1.0, 0.0}, {1.0, 0.0}};
    if (shape == StudyShape::broken_line)
        points = {at_angle(std::numbers::pi * 7.0 / 6.0),
                  {0.0, 0.5 * (std::sqrt(3.0) - 1.0)},
                  at_angle(-std::numbers::pi / 6.0)};
    for (Vec2& point : points)
        point = centre + radius * point;
    if (std::fmod(first, 2.0) >= 1.0)
        std::ranges::reverse(points);
    return contour_through(std::string(names[static_cast<std::size_t>(shape)]), points, false);
}

} // namespace

std::optional<StudyShape> study_shape_named(std::string_view name) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name)
            return static_cast<StudyShape>(i);
    return std::nullopt;
}

double usual_radius_mm(StudyShape shape) {
    switch (shape) {
    case StudyShape::circle:
        return 40.0;
    case StudyShape::triangle:
        return 50.0 / 1.5;
    case StudyShape::curve:
    case StudyShape::line:
    case StudyShape::broken_line:
        return 100.0;
    default:
        return 50.0;
    }
}

Contour study_shape(StudyShape shape, Vec2 centre, double radius_mm, double first) {
    switch (shape) {
    case StudyShape::circle:
        return circle(centre, radius_mm, first);
    case StudyShape::curve:
        return curve(centre, radius_mm, first);
    case StudyShape::line:
    case StudyShape::broken_line:
        return line(shape, centre, radius_mm, first);
    default:
        return polygon(shape, centre, radius_mm, first);
    }
}

} // namespace tp
