// SPDX-License-Identifier: Apache-2.0
#include "core/servo/real_time.hpp"

#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>

namespace tp {

bool prefer_real_time(int level) noexcept {
    prctl(PR_SET_TIMERSLACK, 1UL);
    sched_param priority{};
    priority.sched_priority = level;
    return sched_setscheduler(0, SCHED_FIFO, &priority) == 0;
}

bool lock_memory(const void* data, std::size_t size) noexcept {
    constexpr std::size_t stack_bytes = 64 * 1024;
    volatile char stack[stack_bytes]; // touched, so that the pages are there
    for (std::size_t i = 0; i < stack_bytes; i += 1024)
        stack[i] = 0;
    return mlock(const_cast<const char*>(stack), stack_bytes) == 0 && mlock(data, size) == 0;
}

void forget_memory(const void* data, std::size_t size) noexcept { munlock(data, size); }

} // namespace tp
