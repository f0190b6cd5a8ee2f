// SPDX-License-Identifier: Apache-2.0
#include "device/simulated/simulated_device.hpp"

#include <algorithm>

namespace tp {

namespace {
constexpr double longest_step = 0.00025; ///< s; well below the plant's own time constants
constexpr double longest_gap = 0.1;      ///< s; a machine that slept does not make the finger jump
} // namespace

SimulatedDevice::SimulatedDevice(double width_mm, double height_mm, SimulatedPlant plant)
    : width_(width_mm), height_(height_mm), plant_(plant) {}

void SimulatedDevice::move_pointer(Vec2 position) noexcept {
    sent_.x = position.x;
    sent_.y = position.y;
    ++sent_.moved;
    pointer_.publish(sent_);
}

void SimulatedDevice::place_finger(Vec2 position) noexcept {
    ++sent_.placed;
    move_pointer(position);
}

Result<Capabilities> SimulatedDevice::open() {
    Capabilities can;
    can.name = "simulated device";
    const Vec2 half(0.5 * width_, 0.5 * height_);
    can.workspace = {-half, {half.x, -half.y}, half, {-half.x, half.y}};
    can.max_force = max_force_n;
    can.continuous_force = continuous_force_n;
    can.resolution = plant_.quantum;
    can.delay = static_cast<double>(plant_.delay_ticks) * plant_.tick;
    can.calibrated = true;
    force_ = Vec2(0.0);
    return can;
}

void SimulatedDevice::step(double dt) noexcept {
    constexpr double newtons_to_mm = 1000.0; // N/kg = m/s²; the state is in mm
    const Vec2 hand = plant_.hand_stiffness * (anchor_ - position_) - 1e-3 * plant_.hand_damping * velocity_;
    const Vec2 total = force_ + hand - 1e-3 * plant_.damping * velocity_;
    velocity_ += dt * newtons_to_mm / plant_.mass * total;
    const double speed = length(velocity_);
    if (plant_.coulomb > 0.0 && speed > 0.0) {
        const double loss = dt * newtons_to_mm / plant_.mass * plant_.coulomb;
        velocity_ *= std::max(0.0, speed - loss) / speed;
    }
    position_ += dt * velocity_;
    const Vec2 half(0.5 * width_, 0.5 * height_);
    const Vec2 inside = glm::clamp(position_, -half, half);
    if (inside.x != position_.x)
        velocity_.x = 0.0;
    if (inside.y != position_.y)
        velocity_.y = 0.0;
    position_ = inside;
    if (relaxed_.load(std::memory_order_relaxed))
        anchor_ += std::min(1.0, dt / plant_.relaxed_follow) * (position_ - anchor_);
}

std::optional<DeviceState> SimulatedDevice::read(double now) noexcept {
    if (halted_.load(std::memory_order_acquire))
        force_ = Vec2(0.0);
    const Pointer pointer = pointer_.latest();
    if (pointer.moved != seen_.moved) {
        anchor_ = {pointer.x, pointer.y};
        if (pointer.placed != seen_.placed) {
            position_ = anchor_;
            velocity_ = Vec2(0.0);
        }
        seen_ = pointer;
    }
    if (!started_) {
        started_ = true;
        time_ = now;
    }
    double left = std::min(now - time_, longest_gap);
    while (left > 1e-12) {
        const double dt = std::min(left, longest_step);
        step(dt);
        left -= dt;
    }
    time_ = now;
    DeviceState state{now, position_, 0};
    if (plant_.quantum > 0.0)
        state.position = plant_.quantum * glm::round(position_ / plant_.quantum);
    return state;
}

void SimulatedDevice::stop() noexcept {
    halt();
    started_ = false;
}

bool SimulatedDevice::write(const SafeForce& force) noexcept {
    halted_.store(false, std::memory_order_release);
    newest_ = (newest_ + 1) % on_their_way_.size();
    on_their_way_[newest_] = force.newtons();
    const std::size_t delay = std::min(plant_.delay_ticks, on_their_way_.size() - 1);
    force_ = on_their_way_[(newest_ + on_their_way_.size() - delay) % on_their_way_.size()];
    return true;
}

} // namespace tp
