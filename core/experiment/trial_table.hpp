// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/experiment/experiment.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

inline constexpr std::size_t most_trial_table_bytes = std::size_t{64} << 20;

/// What came of one trial.
struct TrialRecord {
    int participant = 0; ///< a number, from 1; never a name
    int trial = 0;       ///< of this person, from 1, training and repeated ones too
    int repetition = 0;  ///< of the condition, from 1
    bool training = false;
    std::size_t condition = 0;      ///< of the experiment; in training of Experiment::in_training()
    std::optional<double> error_mm; ///< mean distance of the finger from the path, over its samples
    double time_s = 0.0;            ///< from the start to the end or the answer
    std::string answer{};           ///< where something is named; empty: none was given in time
    bool repeated =
        false; ///< it does not count and is done again: a knot was missed, or somebody broke it off
    std::uint64_t seed = 0;
    bool operator==(const TrialRecord&) const = default;
};

/// Whether what was named is what it was.
bool is_right(const Experiment& experiment, const TrialRecord& record);

/// The table of an experiment's trials as CSV (RFC 4180), tidy: a line a trial, a column a factor (Wickham, Journal of Statistical
/// Software 59, 2014): experiment, participant, trial, repetition, training, the factors by name, error_mm, time_s, answer,
/// correct, repeated, seed. `columns` is the first line.
std::string trial_columns(const Experiment& experiment);
std::string trial_line(const Experiment& experiment, const TrialRecord& record);

/// The trials of a table, and what was said of those that could not be used.
struct TrialTable {
    std::vector<TrialRecord> records;
    bool torn = false; ///< the last line is not whole: it was being written; it is left out
};
/// An error is one sentence with the number of the line.
Result<TrialTable> read_trials(const Experiment& experiment, std::string_view csv);

} // namespace tp
