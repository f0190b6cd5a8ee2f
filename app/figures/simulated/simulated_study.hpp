// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/figures/simulated/simulated_trial.hpp"
#include "core/study_folder/study_writer.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace tp {

/// A person who has missed a trial so often does not go on.
inline constexpr int most_simulated_attempts = 25;

/// How many trials were done, of how many that are planned; from several threads, one at a time.
using SimulationProgress = std::function<void(std::size_t done, std::size_t planned)>;

struct SimulatedStudy {
    std::size_t trials = 0, repeated = 0;
    double simulated_s = 0.0;         ///< of trials
    double led_s = 0.0;               ///< of the guided tour to their starts
    std::vector<std::string> remarks; ///< sentences: who did not go on, and why
};

/// Lets simulated people with the numbers `first` … `first + participants - 1` do what is left for them of a study, `jobs` ≥ 1 at a
/// time. The same study's seed gives the same files, whatever `jobs`; another `bench` others. An error where a trial cannot be
/// made or kept; what was kept before it stays. `stopped` is asked between trials.
Result<SimulatedStudy> simulate_study(StudyWriter& writer, int first, int participants,
                                      const SimulatedBench& bench, const StudyFaces* faces, int jobs,
                                      const SimulationProgress& progress,
                                      const std::function<bool()>& stopped);

} // namespace tp
