// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/sample_scenes.hpp"

#include <cmath>

namespace tp {

namespace {

Contour circle(double radius) {
    constexpr double handle = 0.5522847498; // of a cubic for a quarter; 0.03 % of the radius off
    const auto quarter = [&](Vec2 a, Vec2 b) { return Cubic{a, a + handle * b, b + handle * a, b}; };
    const Vec2 x(radius, 0.0);
    const Vec2 y(0.0, radius);
    return {"circle", {quarter(x, y), quarter(y, -x), quarter(-x, -y), quarter(-y, x)}, true};
}

Contour triangle(double height) {
    const double half_side = height / std::sqrt(3.0);
    return contour_through("triangle", {{-half_side, -height / 3.0}, {half_side, -height / 3.0}, {0.0, 2.0 * height / 3.0}},
                           true);
}

/// Three waves that grow flatter to the right, so that no stretch is like another.
Contour curve(double width) {
    const double left = -0.5 * width;
    const double step = width / 3.0;
    const auto wave = [&](int i, double up, double down) {
        const Vec2 a(left + i * step, 0.0);
        const Vec2 b(left + (i + 1) * step, 0.0);
        return Cubic{a, a + Vec2(0.4 * step, up), b - Vec2(0.4 * step, down), b};
    };
    return {"curve", {wave(0, 90.0, 90.0), wave(1, 90.0, 50.0), wave(2, 50.0, 30.0)}, false};
}

} // namespace

Scene sample_scene(LabShape shape, double width_mm, double height_mm) {
    switch (shape) {
    case LabShape::circle: return {width_mm, height_mm, {circle(40.0)}};
    case LabShape::triangle: return {width_mm, height_mm, {triangle(50.0)}};
    case LabShape::curve: return {width_mm, height_mm, {curve(200.0)}};
    }
    return {};
}

} // namespace tp
