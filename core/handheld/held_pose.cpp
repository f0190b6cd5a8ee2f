// SPDX-License-Identifier: Apache-2.0
#include "core/handheld/held_pose.hpp"

#include <cmath>
#include <numbers>

namespace tp {

namespace {
constexpr double nearest_m = 0.05;
double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }
} // namespace

double CameraOptics::focal(double zoom) const { return zoom * 0.5 / std::tan(0.5 * radians(field_deg)); }

std::optional<Projected> projected(const ScenePlace& place, const HeldPose& pose,
                                   const CameraOptics& optics) {
    const double pan = radians(pose.pan_deg);
    const double tilt = radians(pose.tilt_deg);
    const double roll = radians(pose.roll_deg);
    const double ahead = place.ahead_m - pose.forward_m;
    const double x = place.right_m * std::cos(pan) - ahead * std::sin(pan);
    const double level = place.right_m * std::sin(pan) + ahead * std::cos(pan);
    const double y = place.up_m * std::cos(tilt) - level * std::sin(tilt);
    const double z = place.up_m * std::sin(tilt) + level * std::cos(tilt);
    if (!(z >= nearest_m))
        return std::nullopt;
    // A camera turned clockwise sees everything turned the other way.
    const double right = x * std::cos(roll) - y * std::sin(roll);
    const double up = x * std::sin(roll) + y * std::cos(roll);
    const double focal = optics.focal(pose.zoom);
    return Projected{{0.5 + focal * right / z, 0.5 - focal * optics.aspect * up / z}, z};
}

double picture_motion(const HeldPose& before, const HeldPose& after, double dt, const CameraOptics& optics) {
    const double turned = std::hypot(after.pan_deg - before.pan_deg, after.tilt_deg - before.tilt_deg);
    return optics.focal(after.zoom) * radians(turned) / dt;
}

} // namespace tp
