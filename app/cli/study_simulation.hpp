// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/command_line.hpp"
#include "core/base/result.hpp"
#include "core/experiment/experiment.hpp"

#include <filesystem>

namespace tp {

/// The experiment of a file, or one of the program's own by its name or number. An error, in one sentence.
Result<Experiment> experiment_of(const std::filesystem::path& file);
/// The options of `study simulate` beside `out`, `seed` and `json`.
void add_simulation_options(VerbLine& line);
/// `study simulate FILE`: its exit code.
int simulate_study_verb(const VerbLine& line, const std::filesystem::path& file);
/// `study replicate FILE`: studies of several seeds beside what was published; its exit code.
int replicate_study_verb(const VerbLine& line, const std::filesystem::path& file);

} // namespace tp
