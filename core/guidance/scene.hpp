// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/contour.hpp"
#include "core/geometry/flatten.hpp"
#include "core/geometry/polyline.hpp"

#include <string>
#include <vector>

namespace tp {

/// What a finger can feel: named contours on a touch surface, in the surface frame (mm, origin at the centre,
/// x right, y up).
struct Scene {
    double width_mm = 0.0;
    double height_mm = 0.0;
    std::vector<Contour> contours;

    Rect surface() const {
        const Vec2 half(0.5 * width_mm, 0.5 * height_mm);
        return {-half, half};
    }
};

/// A scene as straight segments, and nothing else that a force needs to know.
struct FlatScene {
    std::vector<std::string> names; ///< one a contour
    std::vector<Polyline> lines;    ///< one a contour, in the same order
};

FlatScene flatten(const Scene& scene, const FlattenTolerance& tolerance = {});

} // namespace tp
