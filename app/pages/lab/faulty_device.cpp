// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/faulty_device.hpp"

namespace tp {

bool FaultyDevice::dropped() noexcept {
    random_ ^= random_ << 13U; // xorshift (Marsaglia 2003)
    random_ ^= random_ >> 7U;
    random_ ^= random_ << 17U;
    return static_cast<double>(random_ >> 11U) * 0x1p-53 < drop.load(std::memory_order_relaxed);
}

std::optional<DeviceState> FaultyDevice::read(double now) noexcept {
    const std::optional<DeviceState> reading = device_.read(now); // its time goes on, whether it is heard or not
    return dropped() || silent || unplugged ? std::nullopt : reading;
}

bool FaultyDevice::write(const SafeForce& force) noexcept {
    if (const double hang = hang_.exchange(0.0); hang > 0.0)
        clock_.sleep_until(clock_.now() + hang);
    if (unplugged || refuses) {
        device_.halt();
        return false;
    }
    return device_.write(its_motors_off ? SafeForce{} : force);
}

} // namespace tp
