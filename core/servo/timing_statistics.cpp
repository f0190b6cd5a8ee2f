// SPDX-License-Identifier: Apache-2.0
#include "core/servo/timing_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

void TimingStatistics::record(double seconds) noexcept {
    const double value = seconds > 0.0 ? seconds : 0.0;
    std::size_t bucket = 0;
    if (value > smallest) {
        const double place = std::ceil(std::log2(value / smallest) * buckets_per_octave);
        bucket = std::min(static_cast<std::size_t>(std::min(place, 1e6)), buckets_.size() - 1);
    }
    buckets_[bucket].fetch_add(1, std::memory_order_relaxed);
    count_.fetch_add(1, std::memory_order_relaxed);
    if (value > max_.load(std::memory_order_relaxed))
        max_.store(value, std::memory_order_relaxed);
}

double TimingStatistics::quantile(double q) const noexcept {
    const std::uint64_t all = count();
    if (all == 0)
        return 0.0;
    const auto wanted =
        static_cast<std::uint64_t>(std::ceil(std::clamp(q, 0.0, 1.0) * static_cast<double>(all)));
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < buckets_.size(); ++i) {
        seen += buckets_[i].load(std::memory_order_relaxed);
        if (seen >= std::max<std::uint64_t>(wanted, 1))
            return std::min(max(), smallest * std::exp2(static_cast<double>(i) / buckets_per_octave));
    }
    return max();
}

} // namespace tp
