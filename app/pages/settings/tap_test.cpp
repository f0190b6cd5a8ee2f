// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/tap_test.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace tp {

double TapTest::pause_before(int tick) {
    constexpr std::array pauses{1.5, 2.1, 1.3, 2.6, 1.7, 1.2, 2.3};
    return pauses[static_cast<std::size_t>(tick) % pauses.size()];
}

void TapTest::tapped(double time) {
    if (!tick_)
        return;
    const double delay = time - *std::exchange(tick_, std::nullopt);
    if (delay >= soonest_s && delay <= latest_s)
        delays_.push_back(delay);
}

std::optional<double> TapTest::latency() const {
    if (delays_.size() < fewest_taps)
        return std::nullopt;
    std::vector<double> sorted = delays_;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t half = sorted.size() / 2;
    const double median = sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
    return std::clamp(median - reaction_s, 0.0, longest_latency_s);
}

} // namespace tp
