// SPDX-License-Identifier: Apache-2.0
#include "device/awaited_word.hpp"

namespace tp {

void await_change(const std::atomic<std::uint32_t>& word, std::uint32_t seen) noexcept {
    word.wait(seen, std::memory_order_acquire);
}

void wake_one(std::atomic<std::uint32_t>& word) noexcept { word.notify_one(); }

} // namespace tp
