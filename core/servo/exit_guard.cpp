// SPDX-License-Identifier: Apache-2.0
#include "core/servo/exit_guard.hpp"

#include "core/servo/ending_signals.hpp"

#include <array>
#include <atomic>
#include <cstdlib>
#include <mutex>

namespace tp {

namespace {

// Constant-initialised and never destroyed: a signal may come before main and after the statics are gone.
std::array<std::atomic<Haltable*>, 16> guarded{};
static_assert(std::atomic<Haltable*>::is_always_lock_free);
std::atomic<bool> is_leaving{false};

void halt_all() noexcept {
    is_leaving.store(true, std::memory_order_release);
    for (const std::atomic<Haltable*>& slot : guarded)
        if (Haltable* const device = slot.load(std::memory_order_acquire))
            device->halt();
}

} // namespace

ExitGuard::ExitGuard(Haltable& device) noexcept {
    static std::once_flag once;
    std::call_once(once, [] {
        on_ending_signals(halt_all);
        std::atexit(halt_all);
#if !defined(__MINGW32__) && !defined(__APPLE__) // whose libraries have no such thing
        std::at_quick_exit(halt_all);
#endif
    });
    for (std::size_t i = 0; i < guarded.size(); ++i) {
        Haltable* free = nullptr;
        if (guarded[i].compare_exchange_strong(free, &device)) {
            slot_ = static_cast<int>(i);
            return;
        }
    }
}

bool ExitGuard::leaving() noexcept { return is_leaving.load(std::memory_order_acquire); }

ExitGuard::~ExitGuard() {
    if (guarding())
        guarded[static_cast<std::size_t>(slot_)].store(nullptr, std::memory_order_release);
}

} // namespace tp
