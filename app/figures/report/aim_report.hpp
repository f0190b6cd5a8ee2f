// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/figures/report/csv_table.hpp"
#include "core/base/result.hpp"
#include "core/handheld/aim_trial.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// Many simulated people who each want one picture, once with each guidance from the same start.
struct AimReport {
    Aim aim = Aim::middle;
    std::array<std::vector<AimTrialResult>, all_guidance.size()> results; ///< in the order of `all_guidance`
    std::array<AimShares, all_guidance.size()> shares;
};

/// `people` ≥ 1; their seeds follow from `seed`. `told` hears how much is done, 0 … 1; where `stopped` says so, it ends early with
/// fewer people.
AimReport measure_aiming(Aim aim, int people, std::uint64_t seed,
                         const std::function<void(double)>& told = {},
                         const std::function<bool()>& stopped = {});

/// What becomes of words and tone where something that was assumed is otherwise.
struct AimVariation {
    std::string what;
    AimShares shares;
};
std::vector<AimVariation> vary_assumptions(Aim aim, int people, std::uint64_t seed,
                                           const std::function<void(double)>& told = {},
                                           const std::function<bool()>& stopped = {});

/// One row a guidance: shares and medians.
CsvTable shares_table(const AimReport& report);
/// One row a person: the start, and when each guidance had led to the picture; empty: not within the trial.
CsvTable people_table(const AimReport& report, std::uint64_t seed);
/// One row an assumption.
CsvTable variations_table(const std::vector<AimVariation>& variations);
/// aim.png and aim.svg in `folder`: the share framed over time, a line a guidance.
Result<std::filesystem::path> plot_aiming(const std::filesystem::path& folder, const AimReport& report);

/// "middle", "thirds", "head-and-shoulders", "everybody"
std::string name_of(Aim aim);
std::optional<Aim> aim_named(const std::string& name);

} // namespace tp
