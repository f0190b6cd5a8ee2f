// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace tp {

/// How far the force that a moving finger is given is from the curves' own, at one speed.
struct DeliveredRow {
    double speed_mm_s = 0.0;
    double mean_n =
        0.0; ///< of |delivered − exact|, over the ticks within the band in which no jump is being slowed
    double p99_n = 0.0;
    double law_mean_n = 0.0; ///< what the law has of that by itself at the same places: its flattened curves
    double law_p99_n = 0.0;
    double with_jumps_mean_n =
        0.0; ///< over all ticks within the band: the nearest contour changes, and the chain
    double with_jumps_p99_n = 0.0; ///< lets the force turn round at no more than SafetyLimits::max_force_rate
    double jump_share = 0.0;       ///< of the ticks within the band
    double damping_ns_per_m = 0.0; ///< of the device, as it tells
};

/// The hand's path of `length_mm` over the reference face at each speed, through the whole servo loop at 1 kHz with its
/// defaults, without delay. The truth is the exact force of the curves to 1e-6 mm where the finger is at the tick. A
/// jump is a change of the truth beyond K times the way; it is being slowed for as long as the rate needs for it.
std::vector<DeliveredRow> measure_delivered(const std::vector<double>& speeds_mm_s, double damping_ns_per_m,
                                            double length_mm = 3000.0);

/// The speeds of the report, mm/s.
std::vector<double> delivered_speeds();

} // namespace tp
