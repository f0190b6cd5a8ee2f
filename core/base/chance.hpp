// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace tp {

/// Chance that is the same with every compiler: the standard fixes the engine's numbers, not its distributions'.
class Chance {
public:
    explicit Chance(std::uint64_t seed) : engine_(seed) {}
    /// 0 ≤ … < 1
    double share() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * share(); }
    bool happens(double probability) { return share() < probability; }
    /// Normally distributed about 0 with standard deviation 1 (Box, Muller 1958).
    double normal() {
        const double radius = std::sqrt(-2.0 * std::log(1.0 - share()));
        return radius * std::cos(2.0 * std::numbers::pi * share());
    }
    /// A factor about 1, never below a fifth.
    double factor(double spread) { return std::max(0.2, 1.0 + spread * normal()); }

private:
    std::mt19937_64 engine_;
};

} // namespace tp
