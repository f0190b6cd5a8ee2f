// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace tp::testing {

/// What the clock of a device may do to the stamps of its readings.
struct StampTrouble {
    const char* name = "";
    /// The stamp of the troubled reading `i`, counted from 0, whose true one is `stamp`; the last untroubled one
    /// was `last`. s.
    double (*stamped)(double stamp, double last, int i) = nullptr;
    /// Readings that pass until the newest is taken; in the readings that never are: s until that is a fault.
    int blind = 2;
    double stale_within = 0.0;
    int back_after = 2; ///< readings until the clock as it was is believed again
};

inline double any_stamp(int i) {
    std::uint64_t bits = 0x9E3779B97F4A7C15U * static_cast<std::uint64_t>(i + 1);
    bits ^= bits >> 29;
    bits *= 0xBF58476D1CE4E5B9U;
    return static_cast<double>(bits >> 40) * 1e-3;
}

/// The readings go on.
inline const std::vector<StampTrouble>& survived_stamps() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    static const std::vector<StampTrouble> all{
        {"one_stamp_from_the_future", [](double s, double, int i) { return i == 0 ? s + 10.0 : s; }},
        {"one_stamp_4_ms_from_the_future", [](double s, double, int i) { return i == 0 ? s + 0.004 : s; }},
        {"one_stamp_from_the_past", [](double s, double, int i) { return i == 0 ? s - 10.0 : s; }},
        {"one_stamp_is_not_a_number", [](double s, double, int i) { return i == 0 ? nan : s; }},
        {"one_stamp_is_infinite", [](double s, double, int i) { return i == 0 ? infinity : s; }},
        {"one_stamp_comes_twice", [](double s, double last, int i) { return i == 0 ? last : s; }},
        {"two_stamps_change_places",
         [](double s, double, int i) { return i == 0   ? s + 0.001
                                              : i == 1 ? s - 0.001
                                                       : s; }},
        {"clock_jumps_back", [](double s, double, int) { return s - 10.0; }},
        {"clock_jumps_ahead", [](double s, double, int) { return s + 10.0; }},
        {"clock_jumps_back_by_3_ms", [](double s, double, int) { return s - 0.003; }},
        {"clock_jumps_ahead_by_3_ms", [](double s, double, int) { return s + 0.003; }},
        {"clock_of_32_bits_of_us_wraps", [](double s, double, int) { return s - 4294.967296; }},
        {"clock_begins_again", [](double s, double last, int) { return s - last; }},
        {"clock_jumps_to_and_fro_each_400_ms",
         [](double s, double, int i) { return i / 400 % 2 == 0 ? s + 10.0 : s; }},
        {"clock_runs_half_a_percent_fast",
         [](double s, double last, int) { return last + 1.005 * (s - last); }},
        {"clock_runs_half_a_percent_slow",
         [](double s, double last, int) { return last + 0.995 * (s - last); }},
        {"clock_counts_1024_to_a_second",
         [](double s, double last, int) { return last + 1.024 * (s - last); }},
        {"clock_counts_1000_to_1024_ms",
         [](double s, double last, int) { return last + (s - last) / 1.024; }},
        {"clock_runs_twice_as_fast", [](double s, double last, int) { return last + 2.0 * (s - last); }},
        {"clock_counts_in_steps_of_4_ms",
         [](double s, double, int) { return 0.004 * std::floor(s / 0.004 + 1e-6); }, 4},
        {"clock_in_steps_of_4_ms_jumps_back",
         [](double s, double, int) { return 0.004 * std::floor(s / 0.004 + 1e-6) - 10.0; }, 8},
        {"clock_stands_still_for_15_ms", [](double s, double last, int i) { return i < 15 ? last : s; }, 17},
    };
    return all;
}

/// None of them is a newer reading.
inline const std::vector<StampTrouble>& stale_stamps() {
    static const std::vector<StampTrouble> all{
        {"stamp_stands_still", [](double, double last, int) { return last; }, 0, 0.022},
        {"stamp_stands_still_in_the_future", [](double, double last, int) { return last + 10.0; }, 0, 0.022},
        {"stamp_stands_still_in_the_past", [](double, double last, int) { return last - 10.0; }, 0, 0.022},
        {"two_old_stamps_take_turns", [](double, double last, int i) { return last - 0.001 * (i % 2); }, 0,
         0.022},
        {"three_old_readings_take_turns",
         [](double, double last, int i) { return last - 0.001 * (2 - i % 3); }, 0, 0.030},
        // Each time round one more must go on from the one that jumped.
        {"sixteen_old_readings_take_turns",
         [](double, double last, int i) { return last - 0.001 * (15 - i % 16); }, 0, 0.320, 32},
        {"stamps_are_any_number", [](double, double, int i) { return any_stamp(i); }, 0, 0.022},
        {"stamps_are_not_numbers",
         [](double, double, int) { return std::numeric_limits<double>::quiet_NaN(); }, 0, 0.022},
        {"clock_runs_backwards", [](double s, double last, int) { return 2.0 * last - s; }, 0, 0.022},
        // What comes gets older and older: 20 ms after 40.
        {"clock_runs_half_as_fast", [](double s, double last, int) { return last + 0.5 * (s - last); }, 0,
         0.065},
    };
    return all;
}

} // namespace tp::testing
