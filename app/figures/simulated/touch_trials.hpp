// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/figures/simulated/touch_worth.hpp"
#include "core/participant/person.hpp"
#include "core/trials/study_shapes.hpp"
#include "core/trials/study_trial.hpp"

#include <optional>

namespace tp {

/// A line of its usual size, as far as it fits, in the middle of the surface; where it begins follows from the seed.
StudyTrial touch_trial(StudyShape shape, std::uint64_t seed);

/// How one person followed a line.
struct TouchFollowing {
    bool done = false; ///< to the end, past every knot
    double time_s = 0.0, error_mm = 0.0;
    std::size_t times_lost = 0; ///< of the force it is not known, and 0
};

/// From the line's beginning, which the person is told.
Result<TouchFollowing> follow_line(const StudyTrial& trial, const Person& person, TouchManner manner,
                                   double latency_s, std::uint64_t seed);
/// From a place of the surface that is not near the line. How long it took; nothing where it was given up.
Result<std::optional<double>> find_line(const StudyTrial& trial, const Person& person, TouchManner manner,
                                        double latency_s, std::uint64_t seed);

} // namespace tp
