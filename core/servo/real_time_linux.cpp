// SPDX-License-Identifier: Apache-2.0
#include "core/servo/real_time.hpp"

#include <cstdint>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace tp {

namespace {

/// sched_setattr(2), for which glibc has no function before 2.41.
struct SchedulingAttributes {
    std::uint32_t size, policy;
    std::uint64_t flags;
    std::int32_t nice;
    std::uint32_t priority;
    std::uint64_t runtime_ns, deadline_ns, period_ns;
};

/// Among programs of the usual priority, who wants the processor for a shorter time at once gets it sooner: since
/// Linux 6.12, for everybody, without a permission. Before that nothing changes.
void prefer_short_slices() noexcept {
    constexpr std::uint64_t shortest_ns = 100'000;
    SchedulingAttributes wish{};
    wish.size = sizeof wish;
    wish.policy = SCHED_OTHER;
    wish.nice = getpriority(PRIO_PROCESS, 0);
    wish.runtime_ns = shortest_ns;
    syscall(SYS_sched_setattr, 0, &wish, 0U);
}

} // namespace

bool prefer_real_time(int level) noexcept {
    prctl(PR_SET_TIMERSLACK, 1UL);
    sched_param priority{};
    priority.sched_priority = level;
    if (sched_setscheduler(0, SCHED_FIFO, &priority) == 0)
        return true;
    prefer_short_slices();
    return false;
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
