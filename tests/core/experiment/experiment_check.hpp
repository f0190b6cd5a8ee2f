// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/experiment/experiment.hpp"

#include <string>
#include <string_view>

namespace tp::test {

/// What must hold for any bytes as an experiment: refused with one sentence, or the same again after it was written, with as many
/// trials as it says and no more than it may have. Empty where all of that holds, else what does not.
std::string complaint_about_experiment(std::string_view text);
/// The same for any bytes as the table of its trials.
std::string complaint_about_trials(std::string_view csv);

/// An experiment with a name for everything.
tp::Experiment small_experiment();

} // namespace tp::test
