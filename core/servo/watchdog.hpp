// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/force_device.hpp"

#include <atomic>

namespace tp {

/// Stands between the servo loop and the device, and takes the force away when the loop no longer ticks.
///
/// The loop reads and writes through `read` and `write`; writing is also its sign of life. Another thread
/// calls `check` about once a millisecond: when the sign of life is older than `late_after`, it ramps the
/// last force to zero within `ramp`; when it is older than `stall_after`, it halts the device, also where the
/// loop hangs inside the device's own read or write. What the watchdog writes is the last safe force made
/// smaller, never another.
///
/// Neither side waits for the other: whoever finds the device in use leaves it alone for this time. Where the
/// watchdog itself hangs inside the device's write for longer than `stall_after`, the loop halts the device.
/// A force that one side writes while the other halts does not stay: the device is halted again after it.
class Watchdog {
public:
    struct Limits {
        double late_after = 0.004;  ///< s; three missed ticks at 1 kHz
        double stall_after = 0.050; ///< s
        double ramp = 0.020;        ///< s
    };

    /// What the device says of itself in one tick.
    struct Reading {
        std::optional<DeviceState> state; ///< nothing where the device gave none, or was in use
        bool lost = false;
        bool motors_off = false;
    };

    Watchdog(ForceDevice& device, const Limits& limits) : device_(device), limits_(limits) {}

    /// The loop's way from the device, at `now` s. Only the loop's thread.
    Reading read(double now) noexcept;
    /// The loop's way to the device, at `now` s. False where the device refused. Only the loop's thread.
    bool write(const SafeForce& force, double now) noexcept;
    /// Share of the last force that was left when the loop came back after the watchdog had stepped in, once;
    /// 1 where it had not. Only the loop's thread.
    double take_share_left() noexcept;
    /// The device was halted, and stays so until `rearm`; the chain is told.
    bool halted() const noexcept { return halted_.load(std::memory_order_acquire); }
    /// Forgets a halt; the loop's thread, when a person engages again.
    void rearm(double now) noexcept;

    /// As before the first write, but for a halt, which stays until `rearm`: no sign of life is awaited. Only while
    /// neither thread runs.
    void rest() noexcept;

    /// The other thread's step, at `now` s. Nothing happens before the first write.
    void check(double now) noexcept;

private:
    static constexpr double no_beat = -1.0;

    void halt() noexcept;
    /// To the device; only whoever has entered.
    bool deliver(const SafeForce& force) noexcept;
    bool enter() noexcept { return !busy_.exchange(true, std::memory_order_acquire); }
    void leave() noexcept { busy_.store(false, std::memory_order_release); }

    ForceDevice& device_;
    Limits limits_;
    std::atomic<bool> busy_{false};
    std::atomic<double> last_beat_{no_beat}; ///< s; negative where none is awaited
    std::atomic<double> watch_entered_{0.0}; ///< s; when the watchdog last took the device, or was about to
    std::atomic<double> share_{1.0};         ///< of last_force_ that is on the device
    std::atomic<bool> halted_{false};
    SafeForce last_force_; ///< only whoever has entered
    Reading last_reading_; ///< only the loop's thread
};

} // namespace tp
