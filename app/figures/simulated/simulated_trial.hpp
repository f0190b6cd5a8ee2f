// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/experiment/finger_path.hpp"
#include "core/experiment/trial_table.hpp"
#include "core/participant/person.hpp"
#include "core/trials/trial_judge.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// What simulated people feel: the program's own servo on the simulated device, in simulated time.
struct SimulatedBench {
    Continuity continuity; ///< of the exact law
    double rate_hz = 1000.0;
    std::size_t delay_ticks = 0; ///< between a force and its acting
};

inline constexpr double simulated_sample_s = 0.01; ///< between samples of the finger's path
/// A person who follows a contour for so long gives it up, and the trial is repeated.
inline constexpr double longest_following_s = 120.0;

/// One trial as it was done.
struct SimulatedTrial {
    TrialState state = TrialState::going;
    std::optional<double> error_mm;
    double time_s = 0.0;
    std::string answer;
    std::vector<FingerSample> path;
};

/// `seed` is of the person's own noise in this trial.
Result<SimulatedTrial> simulate_trial(const StudyTrial& trial, const Person& person,
                                      const SimulatedBench& bench, std::uint64_t seed);

} // namespace tp
