// SPDX-License-Identifier: Apache-2.0
#include "core/servo/real_time.hpp"

#if defined(__linux__)
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#endif

namespace tp {

bool prefer_real_time(int level) noexcept {
#if defined(__linux__)
    prctl(PR_SET_TIMERSLACK, 1UL);
    sched_param priority{};
    priority.sched_priority = level;
    return sched_setscheduler(0, SCHED_FIFO, &priority) == 0;
#else
    static_cast<void>(level);
    return false;
#endif
}

bool lock_memory(const void* data, std::size_t size) noexcept {
#if defined(__linux__)
    constexpr std::size_t stack_bytes = 64 * 1024;
    volatile char stack[stack_bytes]; // touched, so that the pages are there
    for (std::size_t i = 0; i < stack_bytes; i += 1024)
        stack[i] = 0;
    return mlock(const_cast<const char*>(stack), stack_bytes) == 0 && mlock(data, size) == 0;
#else
    static_cast<void>(data);
    static_cast<void>(size);
    return false;
#endif
}

void forget_memory(const void* data, std::size_t size) noexcept {
#if defined(__linux__)
    munlock(data, size);
#else
    static_cast<void>(data);
    static_cast<void>(size);
#endif
}

} // namespace tp
