// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/experiment/experiment.hpp"

#include <string>

namespace tp {

/// README.txt of a study's folder: what each file is, and each column of each table with its unit; for whoever gets the folder, in
/// whatever year.
std::string study_readme(const Experiment& experiment);

} // namespace tp
