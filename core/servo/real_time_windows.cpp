// SPDX-License-Identifier: Apache-2.0
#include "core/servo/real_time.hpp"

// The second needs what the first declares.
// clang-format off
#include <windows.h>
#include <timeapi.h>
// clang-format on

namespace tp {

// Windows knows no levels within a class. Its timer, 15.6 ms coarse by itself, is set to 1 ms for the whole process.
bool prefer_real_time(int) noexcept {
    timeBeginPeriod(1);
    return SetThreadPriority(GetCurrentThread(), THREAD_PRIORITY_TIME_CRITICAL) != 0;
}

bool lock_memory(const void* data, std::size_t size) noexcept {
    constexpr std::size_t stack_bytes = 64 * 1024;
    volatile char stack[stack_bytes]; // touched, so that the pages are there
    for (std::size_t i = 0; i < stack_bytes; i += 1024)
        stack[i] = 0;
    return VirtualLock(const_cast<char*>(stack), stack_bytes) != 0 &&
           VirtualLock(const_cast<void*>(data), size) != 0;
}

void forget_memory(const void* data, std::size_t size) noexcept {
    VirtualUnlock(const_cast<void*>(data), size);
}

} // namespace tp
