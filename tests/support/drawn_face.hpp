// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/contour.hpp"

#include <cmath>
#include <vector>

namespace tp::testing {

/// A face drawn with known measures, percent of the distance between the outer corners of its eyes; x right,
/// y down, as in a photograph.
struct DrawnFace {
    double mouth_width = 56.0;
    double opening = 0.0;     ///< between the inner lips
    double corner_lift = 0.0; ///< of both lips
    double lip_height = 18.0; ///< thickness of both lips together
    double eye_opening = 10.0;
    double lid_slope = 0.0;
    double eye_slant = 0.0;
    double chin_depth = 125.0;

    std::vector<Contour> contours() const {
        const double half = 0.5 * mouth_width;
        return {eye("left_eye", 1.0), eye("right_eye", -1.0), lips("outer_lip", half, lip_height + opening),
                lips("inner_lip", 0.9 * half, opening), outline()};
    }

private:
    static constexpr int steps = 200;
    static constexpr double mouth_y = 75.0;
    static constexpr double inner_corner = 18.0;

    /// A profile that is 1 over the middle of a width and 0 at its ends, at t in −1 … 1.
    static double profile(double t) { return 1.0 - std::pow(std::abs(t), 3.0); }

    Contour lips(const char* name, double half, double height) const {
        std::vector<Vec2> points;
        for (int i = 0; i <= 2 * steps; ++i) {
            const bool upper = i <= steps;
            const double t = upper ? -1.0 + 2.0 * i / steps : 3.0 - 2.0 * i / steps;
            // Half-way between the middles lies the mouth's height, and the corners that much above it.
            const double edge = upper ? -0.5 * height : 0.5 * height;
            points.emplace_back(half * t, mouth_y - corner_lift + (corner_lift + edge) * profile(t));
        }
        points.pop_back();
        return contour_through(name, points, true);
    }

    Contour eye(const char* name, double side) const {
        std::vector<Vec2> points;
        for (int i = 0; i < 2 * steps; ++i) {
            const bool upper = i <= steps;
            const double t = upper ? 1.0 - 2.0 * i / steps : -3.0 + 2.0 * i / steps; // 1 outer … −1 inner
            const double corners = -0.5 * eye_slant * t;
            // The lid's slope is the difference between t = −0.5 and t = 0.5, where sin is −1 and 1.
            const double slope = upper ? 0.5 * lid_slope * std::sin(std::acos(-1.0) * t) : 0.0;
            const double lid = (upper ? -0.6 : 0.4) * eye_opening * profile(t) + slope;
            points.emplace_back(side * (0.5 * (50.0 + inner_corner) + 0.5 * (50.0 - inner_corner) * t),
                                corners + lid);
        }
        return contour_through(name, points, true);
    }

    Contour outline() const {
        std::vector<Vec2> points;
        for (int i = 0; i <= steps; ++i) {
            const double angle = std::acos(-1.0) * i / steps;
            points.emplace_back(-75.0 * std::cos(angle), chin_depth * std::sin(angle));
        }
        return contour_through("outline", points, false);
    }
};

} // namespace tp::testing
