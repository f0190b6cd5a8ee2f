// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <cstdint>

namespace tp::vm {

/// What a program that feels with a pad has seen and done by the end of one of its milliseconds.
struct PadReading {
    double time = 0.0; ///< s, the machine's monotonic clock
    Vec2 place{0.0};   ///< mm, the newest
    bool touched = false;
    bool lost = false;
    std::uint64_t ticks = 0;     ///< that were taken since the program began
    double longest_call_s = 0.0; ///< of its calls of the pad since it was opened
};

inline constexpr double line_every_mm = 3.0; ///< of the lines that are felt, upright

} // namespace tp::vm
