// SPDX-License-Identifier: Apache-2.0
#include "core/handheld/seen_people.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace tp {

namespace {

/// Share of the box that is in the picture.
double inside(const Rect& box) {
    const Vec2 low = glm::clamp(box.min, Vec2(0.0), Vec2(1.0));
    const Vec2 high = glm::clamp(box.max, Vec2(0.0), Vec2(1.0));
    return (high.x - low.x) * (high.y - low.y) / (box.width() * box.height());
}

} // namespace

AimFrame seen_people(const std::vector<ScenePlace>& people, const HeldPose& pose, const CameraOptics& optics,
                     const DetectorManner& manner, Chance& chance) {
    AimFrame frame;
    frame.aspect = optics.aspect;
    const double roll = pose.roll_deg * std::numbers::pi / 180.0;
    for (const ScenePlace& person : people) {
        const bool missed = chance.happens(manner.missed);
        const std::array<double, 4> error{manner.jitter * chance.normal(), manner.jitter * chance.normal(),
                                          manner.jitter * chance.normal(), manner.jitter * chance.normal()};
        const auto head = projected(person, pose, optics);
        if (missed || !head)
            continue;
        const double widths_per_m = optics.focal(pose.zoom) / head->ahead_m;
        const Vec2 size{face_width_m * widths_per_m, face_height_m * widths_per_m * optics.aspect};
        AimFace face;
        face.box = {head->at - 0.5 * size + size * Vec2(error[0], error[1]),
                    head->at + 0.5 * size + size * Vec2(error[2], error[3])};
        if (size.y < manner.least_height || inside(face.box) < manner.least_inside)
            continue;
        const double eye = 0.5 * eyes_m * widths_per_m;
        const Vec2 to_right{eye * std::cos(roll), -eye * std::sin(roll) * optics.aspect};
        const Vec2 above{0.0, -0.1 * size.y};
        face.eyes = {{head->at + above - to_right, head->at + above + to_right}};
        frame.faces.push_back(std::move(face));
    }
    return frame;
}

AimFrame mirrored(AimFrame frame) {
    for (AimFace& face : frame.faces) {
        face.box = {{1.0 - face.box.max.x, face.box.min.y}, {1.0 - face.box.min.x, face.box.max.y}};
        if (face.eyes)
            for (Vec2& eye : *face.eyes)
                eye.x = 1.0 - eye.x;
    }
    if (frame.horizon_deg)
        frame.horizon_deg = -*frame.horizon_deg;
    return frame;
}

} // namespace tp
