// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/finger_servo.hpp"

#include <utility>

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
    : size_(surface), surface_{0.5 * Vec2(-surface.width_mm, -surface.height_mm),
                               0.5 * Vec2(surface.width_mm, surface.height_mm)},
      settings_(settings), plant_(plant), drive_(simulated_drive()), max_force_(settings.limits.max_force) {}

std::unique_ptr<DeviceDrive> FingerServo::simulated_drive() {
    auto device = std::make_unique<SimulatedDevice>(size_.width_mm, size_.height_mm, plant_);
    simulated_ = device.get();
    const Capabilities can = device->open().value();
    return std::make_unique<DeviceDrive>(std::move(device), can, settings_);
}

std::unique_ptr<DeviceDrive> FingerServo::exchange(std::unique_ptr<DeviceDrive> drive) {
    drive_->loop().disengage();
    engaged_ = false;
    tour_number_ = 0;
    seen_from_ = 0;
    std::unique_ptr<DeviceDrive> before = std::exchange(drive_, std::move(drive));
    drive_->loop().set_max_force(max_force_);
    if (!felt_.lines.empty())
        show(std::move(scene_));
    return before;
}

std::unique_ptr<DeviceDrive> FingerServo::use(std::unique_ptr<DeviceDrive> real) {
    simulated_ = nullptr;
    std::unique_ptr<DeviceDrive> before = exchange(std::move(real));
    stir();
    drive_->loop().start();
    return before;
}

std::unique_ptr<DeviceDrive> FingerServo::use_simulated() {
    const Vec2 at = finger();
    std::unique_ptr<DeviceDrive> before = exchange(simulated_drive());
    place(at);
    return before;
}

std::string FingerServo::show(Scene scene) {
    Result<std::unique_ptr<HapticScene>> made = make_haptic_scene(scene);
    if (!made)
        return made.error();
    scene_ = std::move(scene);
    felt_ = (*made)->flat;
    tour_number_ = 0;
    relax(false);
    drive_->loop().render(std::move(*made));
    start();
    return {};
}

void FingerServo::start() {
    stir();
    if (state_ == State::awake || real())
        drive_->loop().start();
}

bool FingerServo::park() {
    if (real() || state_ != State::awake)
        return !real();
    drive_->loop().stop();
    state_ = State::parked;
    return true;
}

void FingerServo::stir() {
    if (state_ != State::parked || felt_.lines.empty())
        return;
    state_ = State::awake;
    drive_->loop().start();
    if (stirred_)
        stirred_();
}

void FingerServo::rest() {
    const bool parked = std::exchange(state_, State::resting) == State::parked;
    disengage();
    if (!real() && (parked || drive_->loop().running()))
        use_simulated(); // a new one, and the old one's threads end
}

void FingerServo::wake() {
    state_ = State::awake;
    if (!felt_.lines.empty())
        start();
}

void FingerServo::clear() {
    scene_ = {};
    felt_ = {};
    tour_number_ = 0;
    relax(false);
    drive_->loop().render(nullptr);
    park();
}

Vec2 FingerServo::inside(Vec2 p) const { return glm::clamp(p, surface_.min, surface_.max); }

void FingerServo::relax(bool relaxed) {
    if (simulated_ != nullptr)
        simulated_->relax(relaxed);
}

void FingerServo::place(Vec2 pointer) {
    if (simulated_ == nullptr)
        return;
    pointer_ = inside(pointer);
    simulated_->place_finger(pointer_);
    stir();
    seen_from_ = snapshot().ticks + 2; // a tick under way may have looked before
}

Vec2 FingerServo::finger() const {
    const ServoSnapshot now = snapshot();
    return now.ticks < seen_from_ ? pointer_ : now.finger();
}

void FingerServo::move(Vec2 pointer) {
    if (simulated_ == nullptr)
        return;
    pointer_ = inside(pointer);
    simulated_->move_pointer(pointer_);
    stir();
}

void FingerServo::lead_along(std::size_t contour) {
    Result<std::unique_ptr<HapticScene>> made = make_haptic_scene(scene_);
    if (!made || contour >= felt_.lines.size())
        return;
    (*made)->tour = felt_.lines[contour];
    relax(true);
    stir();
    tour_number_ = drive_->loop().render(std::move(*made));
}

void FingerServo::let_go() {
    if (!leads())
        return;
    tour_number_ = 0;
    move(snapshot().finger());
    relax(false);
    if (Result<std::unique_ptr<HapticScene>> made = make_haptic_scene(scene_))
        drive_->loop().render(std::move(*made));
}

bool FingerServo::has_led() const {
    const ServoSnapshot now = snapshot();
    return leads() && now.scene == tour_number_ && now.tour_finished;
}

void FingerServo::engage() {
    stir();
    engaged_ = true;
    drive_->loop().engage();
}

void FingerServo::disengage() {
    stir();
    engaged_ = false;
    drive_->loop().disengage();
}

void FingerServo::set_max_force(double newtons) {
    max_force_ = newtons;
    drive_->loop().set_max_force(newtons);
}

} // namespace tp
