// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace tp {

/// One click to be heard.
struct Click {
    double time = 0.0;      ///< s, of the clock that the stream goes by
    double amplitude = 0.0; ///< 0 … 1
    double sharpness = 0.0; ///< 0 … 1
    double seconds = 0.0;
};

/// Clicks on their way from one thread to the loudspeaker's. Neither locks, waits or allocates.
class ClickList {
public:
    static constexpr std::uint64_t room = 64;

    /// False where there is no room left: nobody takes them.
    bool push(const Click& click) noexcept;
    /// Those that were pushed until now are not to be heard any more. Any thread; from a signal handler, too.
    void hush() noexcept {
        hushed_.store(pushed_.load(std::memory_order_acquire), std::memory_order_release);
    }

    /// The next one; false where there is none. Only the loudspeaker's thread, as `hushed`.
    bool take(Click& click) noexcept;
    /// Whether the one taken last, or one before it, is not to be heard any more.
    bool hushed() const noexcept {
        return taken_.load(std::memory_order_relaxed) <= hushed_.load(std::memory_order_acquire);
    }

private:
    std::array<Click, room> clicks_{};
    std::atomic<std::uint64_t> pushed_{0};
    std::atomic<std::uint64_t> taken_{0};
    std::atomic<std::uint64_t> hushed_{0};
};

static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

} // namespace tp
