// SPDX-License-Identifier: Apache-2.0
#include "audio/guide/click_list.hpp"

namespace tp {

bool ClickList::push(const Click& click) noexcept {
    const std::uint64_t next = pushed_.load(std::memory_order_relaxed);
    if (next - taken_.load(std::memory_order_acquire) >= room)
        return false;
    clicks_[next % room] = click;
    pushed_.store(next + 1, std::memory_order_release);
    return true;
}

bool ClickList::take(Click& click) noexcept {
    const std::uint64_t next = taken_.load(std::memory_order_relaxed);
    if (next == pushed_.load(std::memory_order_acquire))
        return false;
    click = clicks_[next % room];
    taken_.store(next + 1, std::memory_order_release);
    return true;
}

} // namespace tp
