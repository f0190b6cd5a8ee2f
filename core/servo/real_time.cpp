// SPDX-License-Identifier: Apache-2.0
#include "core/servo/real_time.hpp"

#if defined(__linux__)
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>
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

bool lock_memory() noexcept {
#if defined(__linux__) && defined(MCL_ONFAULT)
    rlimit bound{};
    const bool bounded = getrlimit(RLIMIT_MEMLOCK, &bound) != 0 || bound.rlim_cur != RLIM_INFINITY;
    if (bounded && geteuid() != 0)
        return false;
    return mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
#else
    return false;
#endif
}

} // namespace tp
