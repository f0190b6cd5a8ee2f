// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

namespace tp {

/// While one lives, the first Ctrl-C (SIGINT) or SIGTERM asks for an end in good order instead of ending the
/// program; the second one ends it. One at a time in a process.
class StopSignal {
public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    static const std::atomic<bool>& asked();
    /// How a shell is told of it: 128 and the signal's number.
    static int exit_code();
};

} // namespace tp
