// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aiming/aim_frame.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace tp::testing {

/// A face whose middle and height are these shares of a 16:9 picture; its eyes' line is turned clockwise by `tilt_deg`.
inline AimFace face_at(double x, double y, double height = 0.27, double tilt_deg = 0.0) {
    const double width = 0.75 * height * 9.0 / 16.0;
    AimFace face;
    face.box = {{x - 0.5 * width, y - 0.5 * height}, {x + 0.5 * width, y + 0.5 * height}};
    const double turn = tilt_deg * std::numbers::pi / 180.0;
    const Vec2 half{0.2 * width * std::cos(turn), 0.2 * width * std::sin(turn) * 16.0 / 9.0};
    face.eyes = {{Vec2(x, y - 0.1 * height) - half, Vec2(x, y - 0.1 * height) + half}};
    return face;
}

inline AimFrame frame_of(double time_s, std::vector<AimFace> faces) {
    AimFrame frame;
    frame.time_s = time_s;
    frame.faces = std::move(faces);
    return frame;
}

} // namespace tp::testing
