// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

namespace tp {

/// Notices a writer that hangs in the system, by what it has sent since something was handed to it. The caller's thread, but for
/// `hangs`.
class WriterWatch {
public:
    void restart() noexcept;
    /// Something was handed to the writer.
    void posted() noexcept { awaited_ = true; }
    /// The writer has sent so many messages by `now`, s.
    void look(std::uint32_t sent, double now) noexcept;
    /// Nothing was sent for a quarter of a second though something should be. Any thread.
    bool hangs() const noexcept { return hangs_.load(std::memory_order_relaxed); }

private:
    bool awaited_ = false;
    std::uint32_t sent_ = 0;
    std::optional<double> since_; ///< s
    std::atomic<bool> hangs_{false};
};

} // namespace tp
