// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aiming/aim_frame.hpp"
#include "core/aiming/held_camera.hpp"
#include "core/base/chance.hpp"
#include "core/handheld/held_pose.hpp"

#include <vector>

namespace tp {

/// How surely faces are found in a frame. All of it is assumed, on the bad side of what our detector does.
struct DetectorManner {
    double missed = 0.03;       ///< share of the faces that are not found in a frame
    double jitter = 0.015;      ///< standard deviation of a box's sides, shares of its size
    double least_inside = 0.6;  ///< share of a face that must be in the picture
    double least_height = 0.04; ///< of the picture
    static DetectorManner faultless() { return {0.0, 0.0, 0.6, 0.04}; }
};

inline constexpr double face_width_m = 0.15;  ///< of a detector's box, an adult's (assumed)
inline constexpr double face_height_m = 0.20; ///< the same
inline constexpr double eyes_m = 0.063;       ///< between the pupils (adults' mean; Dodgson 2004)

/// What a detector finds of people whose heads are at these places: boxes and eyes, by geometry alone. Without time and motion.
AimFrame seen_people(const std::vector<ScenePlace>& people, const HeldPose& pose, const CameraOptics& optics,
                     const DetectorManner& manner, Chance& chance);

/// The same frame as the mirrored picture shows it.
AimFrame mirrored(AimFrame frame);

} // namespace tp
