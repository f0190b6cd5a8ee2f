// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/experiment/finger_path.hpp"
#include "core/experiment/trial_table.hpp"
#include "core/participant/person.hpp"
#include "core/trials/trial_judge.hpp"
#include "device/simulated/simulated_device.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// Mass of the handle that is in Person::mass_kg.
inline constexpr double simulated_handle_kg = 0.1;

/// What a simulated person holds.
struct SimulatedBody {
    double mass_kg = simulated_handle_kg;
    double damping_n_s_per_m = 0.3;
    double coulomb_n = 0.0;                             ///< dry friction
    double quantum_mm = 0.0;                            ///< step of its places; 0: none
    /// The safety chain's own limit holds too.
    double max_force_n = SimulatedDevice::max_force_n,
           continuous_force_n = SimulatedDevice::continuous_force_n;
    /// Nobody holds it: the hand moves a mouse and knows where that is, and the finger on its spring is drawn (simulated_device.hpp).
    /// The tone that says where the line is counts as a force that is felt.
    bool drawn = false;
};

/// What simulated people feel: the program's own servo on the simulated device, in simulated time.
struct SimulatedBench {
    Continuity continuity; ///< of the exact law
    double rate_hz = 1000.0;
    std::size_t delay_ticks = 0; ///< between a force and its acting
    SimulatedBody body;
    /// A person's own limit, N; nothing: what a trial asks for is not cut, as with the researcher's consent on the page.
    std::optional<double> limit_n;
    /// Before a trial the guided tour leads a relaxed hand from anywhere to the start, as on the page; else the finger is set down there.
    bool led = false;
};

inline constexpr double simulated_sample_s = 0.01; ///< between samples of the finger's path
/// A person who follows a contour for so long gives it up, and the trial is repeated.
inline constexpr double longest_following_s = 120.0;

/// One trial as it was done.
struct SimulatedTrial {
    TrialState state = TrialState::going;
    std::optional<double> error_mm;
    double time_s = 0.0;
    double led_s = 0.0; ///< until the finger was at the start, before the trial
    std::string answer;
    std::vector<FingerSample> path;
};

/// `seed` is of the person's own noise in this trial.
Result<SimulatedTrial> simulate_trial(const StudyTrial& trial, const Person& person,
                                      const SimulatedBench& bench, std::uint64_t seed);

} // namespace tp
