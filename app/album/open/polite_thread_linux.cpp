// SPDX-License-Identifier: Apache-2.0
#include "app/album/open/polite_thread.hpp"

#include <sys/resource.h>

namespace tp {

void make_thread_polite() {
    constexpr int politeness = 10;
    ::setpriority(PRIO_PROCESS, 0, politeness); // of this thread alone, on Linux
}

} // namespace tp
