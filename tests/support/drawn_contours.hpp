// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/flatten.hpp"
#include "core/geometry/polyline.hpp"
#include "faces/evaluation/contour_error.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace tp {

inline Contour ellipse(const char* name, Vec2 centre, Vec2 radii) {
    std::vector<Vec2> points;
    for (int i = 0; i < 40; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 40;
        points.push_back(centre + radii * Vec2(std::cos(angle), std::sin(angle)));
    }
    return contour_through(name, points, true);
}

inline Rect extent(const std::vector<Contour>& contours, const char* name) {
    return bounds_of(flatten(*contour_named(contours, name)).points);
}

} // namespace tp
