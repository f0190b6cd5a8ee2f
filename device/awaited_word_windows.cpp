// SPDX-License-Identifier: Apache-2.0
#include "device/awaited_word.hpp"

#include <windows.h>

namespace tp {

static_assert(sizeof(std::atomic<std::uint32_t>) ==
              sizeof(std::uint32_t)); // the word itself lies at its address

void await_change(const std::atomic<std::uint32_t>& word, std::uint32_t seen) noexcept {
    while (word.load(std::memory_order_acquire) == seen) // the system may wake it for nothing
        WaitOnAddress(const_cast<std::atomic<std::uint32_t>*>(&word), &seen, sizeof seen, INFINITE);
}

void wake_one(std::atomic<std::uint32_t>& word) noexcept { WakeByAddressSingle(&word); }

} // namespace tp
