// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <optional>

namespace tp {

/// Where a camera looks, as seen from behind it.
struct HeldPose {
    double pan_deg = 0.0;   ///< to the right
    double tilt_deg = 0.0;  ///< up
    double roll_deg = 0.0;  ///< clockwise
    double forward_m = 0.0; ///< from where it was at first, towards pan 0
    double zoom = 1.0;      ///< ≥ 1
};

/// A camera without lens faults.
struct CameraOptics {
    double field_deg = 62.0;    ///< horizontally, without zoom: a telephone's main camera has 60 to 70
    double aspect = 16.0 / 9.0; ///< width over height

    /// Picture widths that a tangent of 1 is long.
    double focal(double zoom) const;
};

/// A place before the camera: metres to the right of, above and before where the camera was at first.
struct ScenePlace {
    double right_m = 0.0;
    double up_m = 0.0;
    double ahead_m = 1.0;
};

/// Where a place is in the picture (x right, y down, 0 … 1 inside), and how far ahead it is, m; nothing of what is behind
/// the camera or in it (nearer than 5 cm).
struct Projected {
    Vec2 at{0.0};
    double ahead_m = 1.0;
};
std::optional<Projected> projected(const ScenePlace& place, const HeldPose& pose, const CameraOptics& optics);

/// How fast the middle of the picture moves between two poses `dt` > 0 s apart, picture widths a second.
double picture_motion(const HeldPose& before, const HeldPose& after, double dt, const CameraOptics& optics);

} // namespace tp
