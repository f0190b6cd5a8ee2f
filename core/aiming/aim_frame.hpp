// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// A face as a detector found it in a small frame. Places are shares of the picture: x 0 … 1 to the right, y
/// 0 … 1 down. What is not known is left out; what is not finite or has no extent is not looked at.
struct AimFace {
    Rect box;
    double confidence = 1.0;                 ///< 0 … 1
    std::optional<std::array<Vec2, 2>> eyes; ///< their middles, in either order
    std::string name;                        ///< whose face it is; empty where nobody knows
    std::optional<double> brightness;        ///< mean of the face, 0 black … 1 white
    bool eyes_shut = false;
};

/// What is known of one frame of the camera.
struct AimFrame {
    double time_s = 0.0;                ///< when it was taken, of a clock that should only run forward
    double aspect = 16.0 / 9.0;         ///< width over height; > 0
    std::vector<AimFace> faces;         ///< in any order
    std::optional<double> surroundings; ///< mean brightness beside the faces, 0 black … 1 white
    std::optional<double> sharpness;    ///< 0 smeared … 1 as sharp as this camera can be
    std::optional<double> motion;       ///< how fast the picture moves, picture widths a second
    /// How far the horizon is turned clockwise in the picture, degrees, as a gravity sensor says; asked where no eyes are seen.
    std::optional<double> horizon_deg;
    /// How far the camera looks up, degrees, as the same sensor says; asked where nobody is seen.
    std::optional<double> elevation_deg;
};

} // namespace tp
