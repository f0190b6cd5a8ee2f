// SPDX-License-Identifier: Apache-2.0
#include "core/servo/watchdog.hpp"

#include "core/servo/exit_guard.hpp"

#include <algorithm>

namespace tp {

Watchdog::Reading Watchdog::read(double now) noexcept {
    last_reading_.state.reset();
    if (!enter())
        return last_reading_;
    last_reading_ = {device_.read(now), device_.lost(), device_.motors_off()};
    leave();
    return last_reading_;
}

bool Watchdog::write(const SafeForce& force, double now) noexcept {
    last_beat_.store(now, std::memory_order_release);
    if (halted())
        return true; // the chain hears of it
    if (!enter()) {
        if (now - watch_entered_.load(std::memory_order_acquire) > limits_.stall_after)
            halt();
        return true;
    }
    last_force_ = force;
    const bool delivered = deliver(force);
    leave();
    return delivered;
}

bool Watchdog::deliver(const SafeForce& force) noexcept {
    if (ExitGuard::leaving()) // which has halted the device
        return true;
    const bool delivered = device_.write(force);
    if (halted() || ExitGuard::leaving()) // meanwhile: what was written later must not stay
        device_.halt();
    return delivered;
}

double Watchdog::take_share_left() noexcept { return share_.exchange(1.0, std::memory_order_acq_rel); }

void Watchdog::rearm(double now) noexcept {
    last_beat_.store(now, std::memory_order_release);
    share_.store(1.0, std::memory_order_release);
    halted_.store(false, std::memory_order_release);
}

void Watchdog::rest() noexcept {
    last_beat_.store(no_beat, std::memory_order_release);
    share_.store(1.0, std::memory_order_release);
    last_force_ = SafeForce{};
    last_reading_ = {};
}

void Watchdog::halt() noexcept {
    halted_.store(true, std::memory_order_release);
    share_.store(0.0, std::memory_order_release);
    device_.halt();
}

void Watchdog::check(double now) noexcept {
    const double beat = last_beat_.load(std::memory_order_acquire);
    if (beat < 0.0 || halted())
        return;
    const double late = now - beat - limits_.late_after;
    if (late <= 0.0)
        return;
    if (now - beat > limits_.stall_after) {
        halt();
        return;
    }
    watch_entered_.store(now, std::memory_order_release);
    if (!enter())
        return;
    const double share = std::clamp(1.0 - late / limits_.ramp, 0.0, share_.load(std::memory_order_relaxed));
    share_.store(share, std::memory_order_release);
    deliver(last_force_.scaled(share));
    leave();
}

} // namespace tp
