// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/command_line.hpp"

#include <filesystem>

namespace tp {

/// The options of `study simulate` beside `out`, `seed` and `json`.
void add_simulation_options(VerbLine& line);
/// `study simulate FILE`: its exit code.
int simulate_study_verb(const VerbLine& line, const std::filesystem::path& file);

} // namespace tp
