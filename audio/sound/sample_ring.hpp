// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <span>
#include <vector>

namespace tp {

/// A bounded queue of samples from one thread to one other. Neither ever waits.
class SampleRing {
public:
    /// Holds `capacity` samples, > 0.
    explicit SampleRing(std::size_t capacity) : samples_(capacity) {}

    std::size_t capacity() const { return samples_.size(); }
    /// How many are in it; for the reader at least, for the writer at most so many.
    std::size_t filled() const;

    /// The writer's: takes as many as there is room for, and says how many.
    std::size_t write(std::span<const float> samples);
    /// The reader's: fills from the front as far as there are samples, and says how many.
    std::size_t read(std::span<float> samples);

private:
    std::vector<float> samples_;
    std::atomic<std::size_t> written_{0}; ///< since the beginning; only the writer changes it
    std::atomic<std::size_t> read_{0};    ///< since the beginning; only the reader changes it
};

} // namespace tp
