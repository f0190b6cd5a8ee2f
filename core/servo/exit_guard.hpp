// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/haltable.hpp"

namespace tp {

/// Halts a device or an output under a bare finger on every way out of the process that still runs code: a signal that ends it (interrupt,
/// termination, hang-up, crash, abort after an uncaught exception, processor-time limit), and exit(). What
/// the signal would have done without this guard follows. A signal that was ignored stays so. From outside
/// (SIGKILL, power) only the device's own watchdog helps, or a process that guards it.
class ExitGuard {
public:
    /// The device must outlive the guard; its halt() is called from a signal handler.
    explicit ExitGuard(Haltable& device) noexcept;
    ~ExitGuard();
    ExitGuard(const ExitGuard&) = delete;
    ExitGuard& operator=(const ExitGuard&) = delete;

    /// A signal that ends the process has come, or exit() was called: from then on nothing but no force may
    /// be written, or a force that another thread writes while the process dies would stay.
    static bool leaving() noexcept;

    /// False where as many devices as there is room for (16) are guarded already.
    bool guarding() const noexcept { return slot_ >= 0; }

private:
    int slot_ = -1;
};

} // namespace tp
