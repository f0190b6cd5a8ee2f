// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/writer_watch.hpp"

namespace tp {

void WriterWatch::restart() noexcept {
    awaited_ = false;
    sent_ = 0;
    since_.reset();
    hangs_.store(false);
}

void WriterWatch::look(std::uint32_t sent, double now) noexcept {
    constexpr double hangs_after = 0.25; ///< s
    if (!awaited_ || sent != sent_) {
        awaited_ = awaited_ && sent == sent_;
        sent_ = sent;
        since_.reset();
    } else if (!since_) {
        since_ = now;
    }
    hangs_.store(since_ && now - *since_ > hangs_after, std::memory_order_relaxed);
}

} // namespace tp
