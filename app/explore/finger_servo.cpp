// SPDX-License-Identifier: Apache-2.0
#include "app/explore/finger_servo.hpp"

namespace tp {

ServoSettings settings_for_a_drawn_finger() {
    ServoSettings settings;
    settings.limits.late_periods = 60.0;
    settings.limits.stale_after = 0.100;
    settings.limits.stall = 1.0;
    return settings;
}

FingerServo::FingerServo(const SurfaceSize& surface, const ServoSettings& settings,
                         const SimulatedPlant& plant)
    : surface_{0.5 * Vec2(-surface.width_mm, -surface.height_mm),
               0.5 * Vec2(surface.width_mm, surface.height_mm)},
      device_(surface.width_mm, surface.height_mm, plant), capabilities_(device_.open().value()),
      loop_(device_, capabilities_, clock_, settings) {}

std::string FingerServo::show(Scene scene) {
    Result<std::unique_ptr<HapticScene>> made = make_haptic_scene(scene);
    if (!made)
        return made.error();
    scene_ = std::move(scene);
    felt_ = (*made)->flat;
    tour_number_ = 0;
    device_.relax(false);
    loop_.render(std::move(*made));
    loop_.start();
    return {};
}

void FingerServo::clear() {
    scene_ = {};
    felt_ = {};
    tour_number_ = 0;
    device_.relax(false);
    loop_.render(nullptr);
}

Vec2 FingerServo::inside(Vec2 p) const { return glm::clamp(p, surface_.min, surface_.max); }

void FingerServo::place(Vec2 pointer) {
    pointer_ = inside(pointer);
    device_.place_finger(pointer_);
    seen_from_ = snapshot().ticks + 2; // a tick under way may have looked before
}

Vec2 FingerServo::finger() const {
    const ServoSnapshot now = snapshot();
    return now.ticks < seen_from_ ? pointer_ : now.finger();
}

void FingerServo::move(Vec2 pointer) {
    pointer_ = inside(pointer);
    device_.move_pointer(pointer_);
}

void FingerServo::lead_along(std::size_t contour) {
    Result<std::unique_ptr<HapticScene>> made = make_haptic_scene(scene_);
    if (!made || contour >= felt_.lines.size())
        return;
    (*made)->tour = felt_.lines[contour];
    device_.relax(true);
    tour_number_ = loop_.render(std::move(*made));
}

void FingerServo::let_go() {
    if (!leads())
        return;
    tour_number_ = 0;
    move(snapshot().finger());
    device_.relax(false);
    if (Result<std::unique_ptr<HapticScene>> made = make_haptic_scene(scene_))
        loop_.render(std::move(*made));
}

bool FingerServo::has_led() const {
    const ServoSnapshot now = snapshot();
    return leads() && now.scene == tour_number_ && now.tour_finished;
}

void FingerServo::engage() {
    engaged_ = true;
    loop_.engage();
}

void FingerServo::disengage() {
    engaged_ = false;
    loop_.disengage();
}

} // namespace tp
