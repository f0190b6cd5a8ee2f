// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/tick_tap.hpp"

namespace tp {

std::optional<DeviceState> TickTap::read(double now) noexcept {
    const std::optional<DeviceState> reading = device_.read(now);
    servo_.store(std::this_thread::get_id(), std::memory_order_relaxed);
    ticking_ = true;
    tick_.time = now;
    if (reading)
        tick_.place = reading->position;
    return reading;
}

bool TickTap::write(const SafeForce& force) noexcept {
    if (servo_.load(std::memory_order_relaxed) != std::this_thread::get_id() || !ticking_)
        return device_.write(force);
    ticking_ = false;
    const bool taken = device_.write(force);
    tick_.force = taken ? force.newtons() : Vec2(0.0);
    const std::uint64_t number = made_.load(std::memory_order_relaxed);
    if (number - taken_.load(std::memory_order_acquire) < ring_size) {
        ring_[number % ring_size] = tick_;
        made_.store(number + 1, std::memory_order_release);
    }
    return taken;
}

std::vector<TickSample> TickTap::take() {
    const std::uint64_t until = made_.load(std::memory_order_acquire);
    std::uint64_t at = taken_.load(std::memory_order_relaxed);
    std::vector<TickSample> samples;
    samples.reserve(until - at);
    for (; at < until; ++at)
        samples.push_back(ring_[at % ring_size]);
    taken_.store(until, std::memory_order_release);
    return samples;
}

} // namespace tp
