// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/bench_clock.hpp"

#include <algorithm>
#include <cstddef>

namespace tp {

void keep(double value) {
    [[maybe_unused]] static volatile double sink = 0.0;
    sink = value;
}

double quantile(std::vector<double> values, double rank) {
    if (values.empty())
        return 0.0;
    const auto place = static_cast<std::size_t>(rank * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
    return values[place];
}

} // namespace tp
