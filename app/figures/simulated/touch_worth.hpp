// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/figures/report/csv_table.hpp"
#include "core/base/result.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace tp {

/// What guides a simulated finger to a line and along it.
enum class TouchManner {
    force,      ///< the exact law by the program's servo, on the simulated device
    resistance, ///< friction on the line, and nothing else
    ticks       ///< one tick at each crossing, and nothing else
};
std::string_view name_of(TouchManner manner); ///< "force", "resistance", "ticks"

inline constexpr double longest_touch_s = 120.0; ///< then a line that is followed or looked for is given up
/// Found: the hand has met the line, and the finger has been so near to it for so long.
inline constexpr double found_mm = 3.0;
inline constexpr double found_s = 0.5;

/// How simulated people found lines and followed them.
struct TouchRow {
    TouchManner manner = TouchManner::force;
    double latency_s = 0.0;                ///< between a place and what is felt of it
    std::size_t trials = 0;                ///< of finding, and as many of following
    std::size_t found = 0, followed = 0;   ///< within longest_touch_s; followed: past every knot to the end
    double find_s = 0.0;                   ///< mean of those found
    double follow_s = 0.0, error_mm = 0.0; ///< means of those followed; error: mean distance to the line
    double lost =
        0.0; ///< mean times that the line was lost, of all trials of following; of the force unknown
};

struct TouchPlan {
    int people = 10;
    std::uint64_t seed = 1;
    int repetitions = 3; ///< of circle, triangle and curve as in the published experiment, for each person
    std::vector<double> latencies_s{0.005, 0.02, 0.05, 0.1};
};

/// A row for the force at 5 ms, and one for each latency of resistance and ticks: the same people and lines. Fewer rows where
/// `stopped` said so; an error where a trial cannot be made.
Result<std::vector<TouchRow>> measure_touch(const TouchPlan& plan,
                                            const std::function<void(double)>& progress,
                                            const std::function<bool()>& stopped);

/// One row of measure_touch; unfinished where `stopped`, asked between trials, said so.
Result<TouchRow> measure_touch_row(const TouchPlan& plan, TouchManner manner, double latency_s,
                                   const std::function<bool()>& stopped);

CsvTable touch_table(const std::vector<TouchRow>& rows);

} // namespace tp
