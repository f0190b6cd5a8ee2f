// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <random>

namespace tp::test {

/// The same numbers on every machine (the distributions of the standard library are not).
class RandomPoints {
public:
    explicit RandomPoints(std::uint64_t seed) : engine_(seed) {}

    std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }
    double number(double from, double to) {
        return from + (to - from) * static_cast<double>(engine_() >> 11u) * 0x1p-53;
    }
    Vec2 point(double reach) { return {number(-reach, reach), number(-reach, reach)}; }

private:
    std::mt19937_64 engine_;
};

} // namespace tp::test
