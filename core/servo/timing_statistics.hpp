// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace tp {

/// How long something took, over millions of times, in a fixed amount of memory: a histogram with sixteen
/// buckets an octave from 16 ns to 17 s, so that a quantile is at most 4.5 % too high. One thread records,
/// any reads.
class TimingStatistics {
public:
    /// `seconds` ≥ 0; NaN and negative count as 0.
    void record(double seconds) noexcept;

    std::uint64_t count() const noexcept { return count_.load(std::memory_order_relaxed); }
    double max() const noexcept { return max_.load(std::memory_order_relaxed); }
    /// The duration, in s, that the share `q` in (0, 1] of all recorded ones does not exceed; 0 where none
    /// was recorded.
    double quantile(double q) const noexcept;

private:
    static constexpr std::size_t buckets_per_octave = 16;
    static constexpr std::size_t octaves = 30;
    static constexpr double smallest = 16e-9; ///< s

    std::array<std::atomic<std::uint64_t>, buckets_per_octave * octaves> buckets_{};
    std::atomic<std::uint64_t> count_{0};
    std::atomic<double> max_{0.0};
};

} // namespace tp
