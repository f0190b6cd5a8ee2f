// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tp {

/// The last samples that were heard, in memory alone. One thread.
class PastSound {
public:
    /// Of at most `capacity` > 0 samples.
    explicit PastSound(std::size_t capacity) : samples_(capacity) {}

    void add(std::span<const std::int16_t> samples);
    void forget() { count_ = 0; }
    /// Those that are remembered, the oldest first.
    std::vector<std::int16_t> all() const;

private:
    std::vector<std::int16_t> samples_;
    std::size_t next_ = 0;  ///< where the next one goes
    std::size_t count_ = 0; ///< that are remembered
};

} // namespace tp
