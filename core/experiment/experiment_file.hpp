// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/experiment/experiment.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace tp {

inline constexpr std::size_t most_experiment_bytes = 64 * 1024;
inline constexpr std::size_t most_study_trials = 10'000; ///< of one person

/// The text of an experiment's file, a line a thing:
///
/// | line | what it says |
/// |------|--------------|
/// | `# …` or nothing | for people who read the file |
/// | `experiment: tracking` | its name: letters, digits, `-` and `_` |
/// | `title: Following contours` | what it is, for people |
/// | `task: follow` or `name` | what a person does |
/// | `factor stiffness: 0.1, 0.2 N/mm` | what varies; the parameters and their units stand in `experiment.cpp` |
/// | `set radius: 40 mm` | what is the same in all trials |
/// | `answer: shape` | the factor that is asked for, where the task is to name |
/// | `order: random` or `latin-square` | see StudyOrder |
/// | `repetitions: 2`, `training: 3`, `break after: 25` | trials |
/// | `training face: 5` | the levels of a factor in training, in place of its own |
/// | `longest trial: 60 s`, `longest training: 20 s` | of one trial; in training |
/// | `surface: 200 x 200 mm` | |
///
/// `experiment`, `task` and a factor must be there; each line but `factor`, `set` and `training FACTOR` once. An error is one sentence with the number
/// of the line.
Result<Experiment> read_experiment(std::string_view text);

/// The same experiment as text.
std::string experiment_text(const Experiment& experiment);

} // namespace tp
