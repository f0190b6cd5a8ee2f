// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/test_scenes.hpp"

namespace tp {

namespace {

/// A quarter of an ellipse as a cubic, from `centre + a` to `centre + b`; 0.03 % of the radius off.
Piece quarter(Vec2 centre, Vec2 a, Vec2 b) {
    constexpr double handle = 0.5522847498;
    return Cubic{centre + a, centre + a + handle * b, centre + b + handle * a, centre + b};
}

Contour ellipse(std::string name, Vec2 centre, double width, double height) {
    const Vec2 x(0.5 * width, 0.0);
    const Vec2 y(0.0, 0.5 * height);
    return {std::move(name),
            {quarter(centre, x, y), quarter(centre, y, -x), quarter(centre, -x, -y), quarter(centre, -y, x)},
            true};
}

} // namespace

Scene reference_face() {
    Scene face{200.0, 200.0, {}};
    face.contours.push_back(ellipse("right_eye", {-32.0, 30.0}, 28.0, 10.0));
    face.contours.push_back(ellipse("left_eye", {32.0, 30.0}, 28.0, 10.0));
    face.contours.push_back(ellipse("outer_lip", {0.0, -45.0}, 44.0, 16.0));
    face.contours.push_back(ellipse("inner_lip", {0.0, -45.0}, 36.0, 2.0));
    const Vec2 x(65.0, 0.0);
    const Vec2 y(0.0, 170.0);
    const Vec2 centre(0.0, 85.0);
    face.contours.push_back({"outline", {quarter(centre, -x, -y), quarter(centre, -y, x)}, false});
    return face;
}

} // namespace tp
