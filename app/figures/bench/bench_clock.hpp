// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ctime>
#include <vector>

namespace tp {

/// Processor time since it was made: what other programs take of the core does not count.
class BusyClock {
public:
    double ns() const {
        return 1e9 * static_cast<double>(std::clock() - start_) / static_cast<double>(CLOCKS_PER_SEC);
    }

private:
    std::clock_t start_ = std::clock();
};

/// Keeps a value alive for the optimiser.
void keep(double value);

/// The value below which the share `rank`, 0 … 1, of `values` lies; 0 for none.
double quantile(std::vector<double> values, double rank);

} // namespace tp
