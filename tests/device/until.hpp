// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace tp::testing {

/// Waits; CTest ends a test that waits for ever.
inline void until(const std::function<bool()>& holds) {
    while (!holds())
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

} // namespace tp::testing
