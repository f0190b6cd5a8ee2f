// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"
#include "core/handheld/held_pose.hpp"

#include <opencv2/core/mat.hpp>

namespace tp {

/// What a camera sees of a photograph that stands before it like a wall.
struct PhotoWall {
    double width_m = 2.2; ///< of the photograph; its height follows
    double ahead_m = 1.5; ///< from where the camera is at first
    Vec2 aim{0.5, 0.5};   ///< the place, shares of the photograph, at which pan 0 and tilt 0 look
};

/// How a frame is taken.
struct FrameTaking {
    cv::Size size{1280, 720};    ///< px
    double exposure = 1.0;       ///< factor of the light, > 0
    double exposed_s = 1.0 / 60; ///< the shutter's time
    double readout_s = 1.0 / 60; ///< from the first row to the last: a rolling shutter; 0: all at once
};

/// The photograph as a frame from `pose`, bilinear; beside the photograph is mid grey. `rate` is how fast the pose changes, degrees,
/// m and zoom a second: rows are taken one after the other, and each is smeared by it.
cv::Mat view_of(const cv::Mat& photo, const PhotoWall& wall, const HeldPose& pose, const HeldPose& rate,
                const CameraOptics& optics, const FrameTaking& taking);

/// Where a pixel of a frame, shares of its size, lies on the photograph, shares of its size; not finite where the camera looks past
/// the wall.
Vec2 place_on_photo(Vec2 in_frame, double photo_aspect, const PhotoWall& wall, const HeldPose& pose,
                    const CameraOptics& optics);

} // namespace tp
