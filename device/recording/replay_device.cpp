// SPDX-License-Identifier: Apache-2.0
#include "device/recording/replay_device.hpp"

#include <algorithm>

namespace tp {

Result<Capabilities> ReplayDevice::open() {
    next_ = 0;
    greatest_difference_ = 0.0;
    return recording_.device;
}

const RecordedTick* ReplayDevice::current() const noexcept {
    return next_ > 0 && next_ <= recording_.ticks.size() ? &recording_.ticks[next_ - 1] : nullptr;
}

std::optional<DeviceState> ReplayDevice::read(double) noexcept {
    if (next_ <= recording_.ticks.size())
        ++next_;
    const RecordedTick* const tick = current();
    return tick != nullptr && tick->fresh ? std::optional(tick->reading) : std::nullopt;
}

bool ReplayDevice::write(const SafeForce& force) noexcept {
    const RecordedTick* const tick = current();
    if (tick == nullptr)
        return false;
    greatest_difference_ = std::max(greatest_difference_, length(force.newtons() - tick->force));
    return !tick->refused;
}

bool ReplayDevice::lost() const noexcept {
    const RecordedTick* const tick = current();
    return tick == nullptr ? next_ > 0 : tick->lost;
}

bool ReplayDevice::motors_off() const noexcept {
    const RecordedTick* const tick = current();
    return tick != nullptr && tick->motors_off;
}

void replay(const TouchRecording& recording, ServoLoop& loop, VirtualClock& clock) {
    for (const RecordedTick& tick : recording.ticks) {
        clock.sleep_until(tick.now);
        loop.tick();
    }
}

} // namespace tp
