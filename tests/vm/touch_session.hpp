// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tp::vm {

/// What a program that touches says of itself when a session ends, by a lost device or because it was told
/// to.
struct TouchSession {
    bool lost = false; ///< the device was
    std::uint64_t ticks = 0;
    std::uint64_t missed = 0;   ///< periods without a tick
    double latest_s = 0.0;      ///< how late the latest tick began
    double compute_p50_s = 0.0; ///< what a tick takes
    double compute_max_s = 0.0;
    bool real_time = false;
};

} // namespace tp::vm
