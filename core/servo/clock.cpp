// SPDX-License-Identifier: Apache-2.0
#include "core/servo/clock.hpp"

#include <chrono>
#include <thread>

namespace tp {

using Seconds = std::chrono::duration<double>;

double SteadyClock::now() noexcept {
    return std::chrono::duration_cast<Seconds>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void SteadyClock::sleep_until(double time) noexcept {
    using Ticks = std::chrono::steady_clock::duration;
    const auto due = std::chrono::steady_clock::time_point(std::chrono::ceil<Ticks>(Seconds(time)));
    while (std::chrono::steady_clock::now() < due) // Windows wakes a thread before its time
        std::this_thread::sleep_until(due);
}

} // namespace tp
