// SPDX-License-Identifier: Apache-2.0
#include "device/simulated/simulated_device.hpp"

#include <algorithm>

namespace tp {

namespace {
constexpr double longest_gap = 0.1; ///< s; a machine that slept does not make the finger jump
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
    can.delay = static_cast<double>(plant_.told_delay_ticks.value_or(plant_.delay_ticks)) * plant_.tick;
    can.damping = plant_.told_damping.value_or(plant_.damping);
    can.calibrated = true;
    force_ = Vec2(0.0);
    return can;
}

void SimulatedDevice::step(double dt) noexcept {
    if (held_.load(std::memory_order_relaxed)) {
        body_.velocity = Vec2(0.0);
        return;
    }
    const double follow = relaxed_.load(std::memory_order_relaxed) ? plant_.relaxed_follow : 0.0;
    motion_.advance(
        body_,
        {plant_.mass, plant_.damping + plant_.hand_damping, plant_.coulomb, plant_.hand_stiffness, follow},
        force_, dt);
    const Vec2 half(0.5 * width_, 0.5 * height_);
    const Vec2 inside = glm::clamp(body_.position, -half, half);
    if (inside.x != body_.position.x)
        body_.velocity.x = 0.0;
    if (inside.y != body_.position.y)
        body_.velocity.y = 0.0;
    body_.position = inside;
}

std::optional<DeviceState> SimulatedDevice::read(double now) noexcept {
    if (halted_.load(std::memory_order_acquire))
        force_ = Vec2(0.0);
    const Pointer pointer = pointer_.latest();
    if (pointer.moved != seen_.moved) {
        body_.anchor = {pointer.x, pointer.y};
        if (pointer.placed != seen_.placed) {
            body_.position = body_.anchor;
            body_.velocity = Vec2(0.0);
        }
        seen_ = pointer;
    }
    if (!started_) {
        started_ = true;
        time_ = now;
    }
    if (const double passed = std::min(now - time_, longest_gap); passed > 1e-12)
        step(passed);
    time_ = now;
    DeviceState state{now, body_.position, 0};
    if (plant_.quantum > 0.0)
        state.position = plant_.quantum * glm::round(body_.position / plant_.quantum);
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
    const std::size_t late = plant_.jitter_ticks > 0 ? lateness_() % (plant_.jitter_ticks + 1) : 0;
    const std::size_t delay = std::min(plant_.delay_ticks + late, on_their_way_.size() - 1);
    force_ = on_their_way_[(newest_ + on_their_way_.size() - delay) % on_their_way_.size()];
    return true;
}

} // namespace tp
