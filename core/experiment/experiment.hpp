// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// What the person does in a trial.
enum class StudyTask : std::uint8_t {
    follow, ///< goes along a contour, from its start past all knots to its end
    name    ///< feels it as long as it takes, then says which it was
};

/// In which order one person meets the conditions.
enum class StudyOrder : std::uint8_t {
    random,      ///< all trials shuffled, another shuffle for each person
    latin_square ///< in each repetition every condition once, balanced over people (Williams, 1949)
};

/// What may vary between trials, or be set for all of them.
enum class StudyParameter : std::uint8_t { stiffness, range, law, path, shape, radius, expression, face };
inline constexpr std::size_t study_parameter_count = 8;

/// A number in a unit, or one of a few words.
struct StudyParameterKind {
    std::string_view name; ///< in files, tables and reports
    std::string_view unit; ///< empty: a word or a count
    double least = 0.0, most = 0.0;
    std::span<const std::string_view> words{}; ///< empty: a number
};
const StudyParameterKind& kind_of(StudyParameter parameter);
std::optional<StudyParameter> parameter_named(std::string_view name);

/// One parameter and the values that it takes, as the file spells them: "0.1", "circle".
struct StudyFactor {
    StudyParameter parameter = StudyParameter::stiffness;
    std::vector<std::string> levels;
};

/// An experiment as data; what a file of `resources/studies` says.
struct Experiment {
    std::string name;  ///< one word, in tables
    std::string title; ///< what it is, for people
    StudyTask task = StudyTask::follow;
    StudyOrder order = StudyOrder::random;
    std::vector<StudyFactor> factors;      ///< at least one; each with at least two levels
    std::vector<StudyFactor> settings;     ///< the same in all trials: one level each
    std::optional<StudyParameter> answer;  ///< where things are named: the factor that is asked for
    int repetitions = 1;                   ///< of each condition
    int training = 0;                      ///< trials before, which do not count
    /// The levels of a factor in training, in place of its own: faces that are not asked for later.
    std::vector<StudyFactor> training_factors;
    std::optional<double> longest_training_s; ///< of a trial in training; nothing: as long as the others
    int trials_between_breaks = 0;         ///< 0: no breaks
    std::optional<double> longest_trial_s; ///< then it ends, or an answer is asked for
    double surface_width_mm = 200.0, surface_height_mm = 200.0;

    /// What training is drawn from: the same experiment with the training factors' levels.
    Experiment in_training() const;
    /// Whether an answer is asked for; in training only where its levels are among the answers.
    bool asks(bool in_training) const;
    std::size_t conditions() const;
    std::size_t trials() const { return conditions() * static_cast<std::size_t>(repetitions); }
    /// Of a condition, 0 … conditions(): an index a factor. The last factor's changes first.
    std::vector<std::size_t> levels_of(std::size_t condition) const;
    std::size_t condition_of(const std::vector<std::size_t>& levels) const;
    /// The value of a parameter in a condition, or as it is set for all; empty where it is neither.
    std::string value_of(StudyParameter parameter, std::size_t condition) const;
};

/// "0.1 N/mm", "circle"
std::string level_words(const StudyFactor& factor, std::size_t level);

} // namespace tp
