// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cerrno>
#include <poll.h>

namespace tp::guard {

/// As poll(2) of one descriptor; no signal ends the wait.
inline int wait_for(int descriptor, short for_what, int wait_ms) {
    pollfd one{descriptor, for_what, 0};
    int ready = 0;
    while ((ready = poll(&one, 1, wait_ms)) < 0 && errno == EINTR) {
    }
    return ready;
}

} // namespace tp::guard
