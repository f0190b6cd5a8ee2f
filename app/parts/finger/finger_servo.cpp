// SPDX-License-Identifier: Apache-2.0
#include "app/parts/finger/finger_servo.hpp"

#include <cmath>
#include <utility>

namespace tp {

namespace {
constexpr double tick_s = 0.001; ///< of the simulated device
}

ServoSettings settings_for_a_drawn_finger() {
    ServoSettings settings;
    settings.limits.late_periods = 60.0;
    settings.limits.stale_after = 0.100;
    settings.limits.stall = 1.0;
    return settings;
}

FingerServo::FingerServo(Vec2 surface, const ServoSettings& settings, const SimulatedPlant& plant,
                         VirtualClock* time)
    : size_(surface), surface_{-0.5 * surface, 0.5 * surface}, settings_(settings), plant_(plant),
      time_(time), drive_(simulated_drive()), max_force_(settings.limits.max_force) {}

std::unique_ptr<DeviceDrive> FingerServo::simulated_drive() {
    auto device = std::make_unique<SimulatedDevice>(size_.x, size_.y, plant_);
    simulated_ = device.get();
    const Capabilities can = device->open().value();
    return std::make_unique<DeviceDrive>(std::move(device), can, settings_, time_);
}

std::unique_ptr<DeviceDrive> FingerServo::exchange(std::unique_ptr<DeviceDrive> drive) {
    drive_->loop().disengage();
    engaged_ = false;
    tour_number_ = 0;
    seen_from_ = 0;
    std::unique_ptr<DeviceDrive> before = std::exchange(drive_, std::move(drive));
    drive_->loop().set_max_force(max_force_);
    if (make_)
        render(std::move(make_));
    return before;
}

std::unique_ptr<DeviceDrive> FingerServo::use(std::unique_ptr<DeviceDrive> real) {
    simulated_ = nullptr;
    std::unique_ptr<DeviceDrive> before = exchange(std::move(real));
    stir();
    start_threads();
    return before;
}

std::unique_ptr<DeviceDrive> FingerServo::use_simulated() {
    const Vec2 at = finger();
    std::unique_ptr<DeviceDrive> before = exchange(simulated_drive());
    place(at);
    return before;
}

std::unique_ptr<TouchDrive> FingerServo::feel_by(std::unique_ptr<TouchDrive> touch) {
    const Vec2 at = finger();
    disengage();
    tour_number_ = 0;
    seen_from_ = 0;
    std::unique_ptr<TouchDrive> before = std::exchange(touch_, std::move(touch));
    if (touch_) {
        stir();
        drive_->loop().stop();
        touch_->show(felt_);
        if (time_ == nullptr)
            touch_->loop().start();
    } else {
        exchange(simulated_drive());
        start();
    }
    place(at);
    return before;
}

std::string FingerServo::show(Scene scene) {
    return render([scene = std::move(scene)] { return make_haptic_scene(scene); });
}

std::string FingerServo::render(Make make) {
    Result<std::unique_ptr<HapticScene>> made = make();
    if (!made)
        return made.error();
    make_ = std::move(make);
    felt_ = (*made)->flat;
    tour_number_ = 0;
    relax(false);
    drive_->loop().render(std::move(*made));
    if (touch_)
        touch_->show(felt_);
    start();
    return {};
}

void FingerServo::start() {
    stir();
    if (state_ == State::awake || real())
        start_threads();
}

void FingerServo::start_threads() {
    if (time_ == nullptr && !touch_)
        drive_->loop().start();
}

bool FingerServo::park() {
    if (real() || touch_ || state_ != State::awake)
        return !real() && !touch_;
    drive_->loop().stop();
    state_ = State::parked;
    return true;
}

void FingerServo::stir() {
    if (state_ != State::parked || felt_.lines.empty())
        return;
    state_ = State::awake;
    start_threads();
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
    make_ = {};
    felt_ = {};
    tour_number_ = 0;
    relax(false);
    drive_->loop().render(nullptr);
    if (touch_)
        touch_->show({});
    park();
}

Vec2 FingerServo::inside(Vec2 p) const { return glm::clamp(p, surface_.min, surface_.max); }

void FingerServo::relax(bool relaxed) {
    if (simulated_ != nullptr)
        simulated_->relax(relaxed);
}

void FingerServo::place(Vec2 pointer) {
    if (real())
        return;
    pointer_ = inside(pointer);
    simulated_->place_finger(pointer_);
    if (touch_)
        touch_->set_down(pointer_);
    stir();
    seen_from_ = snapshot().ticks + 2; // a tick under way may have looked before
}

Vec2 FingerServo::finger() const {
    const ServoSnapshot now = snapshot();
    return now.ticks < seen_from_ ? pointer_ : now.finger();
}

ServoSnapshot FingerServo::snapshot() const {
    ServoSnapshot seen = drive_->loop().snapshot();
    if (!touch_)
        return seen;
    const TouchSnapshot touch = touch_->loop().snapshot();
    seen.x = touch.x;
    seen.y = touch.y;
    seen.fx = seen.fy = 0.0;
    seen.tour_progress = touch.tour_progress;
    seen.ticks = touch.periods;
    seen.scene = touch.scene;
    seen.fault = Fault::none;
    seen.engaged = touch.engaged;
    seen.touring = touch.touring;
    seen.tour_finished = touch.tour_finished;
    return seen;
}

void FingerServo::lift() {
    if (touch_)
        touch_->lift();
}

void FingerServo::move(Vec2 pointer) {
    if (real())
        return;
    pointer_ = inside(pointer);
    simulated_->move_pointer(pointer_);
    if (touch_)
        touch_->move(pointer_);
    stir();
}

void FingerServo::lead_along(std::size_t contour) {
    if (contour < felt_.lines.size())
        lead(felt_.lines[contour]);
}

void FingerServo::lead_to(Vec2 place) { lead({{place}, false}); }

void FingerServo::lead(Polyline way) {
    if (!make_)
        return;
    if (touch_) {
        tour_number_ = touch_->show(felt_, std::move(way));
        return;
    }
    Result<std::unique_ptr<HapticScene>> made = make_();
    if (!made)
        return;
    (*made)->tour = std::move(way);
    relax(true);
    stir();
    tour_number_ = drive_->loop().render(std::move(*made));
}

void FingerServo::let_go() {
    if (!leads())
        return;
    tour_number_ = 0;
    if (touch_) {
        touch_->show(felt_);
        return;
    }
    move(snapshot().finger());
    relax(false);
    if (Result<std::unique_ptr<HapticScene>> made = make_())
        drive_->loop().render(std::move(*made));
}

bool FingerServo::has_led() const {
    const ServoSnapshot now = snapshot();
    return leads() && now.scene == tour_number_ && now.tour_finished;
}

void FingerServo::engage() {
    stir();
    engaged_ = true;
    if (touch_)
        touch_->loop().engage();
    else
        drive_->loop().engage();
}

void FingerServo::disengage() {
    stir();
    engaged_ = false;
    drive_->loop().disengage();
    if (touch_)
        touch_->loop().disengage();
}

void FingerServo::pass(double seconds) {
    if (time_ == nullptr)
        return;
    for (long left = std::lround(seconds / tick_s); left > 0; --left) {
        drive_->loop().tick();
        time_->sleep_until(time_->now() + tick_s);
    }
}

void FingerServo::set_max_force(double newtons) {
    max_force_ = newtons;
    drive_->loop().set_max_force(newtons);
}

} // namespace tp
