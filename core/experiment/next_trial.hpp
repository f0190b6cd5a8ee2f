// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/experiment/experiment.hpp"
#include "core/experiment/trial_order.hpp"
#include "core/experiment/trial_table.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace tp {

/// What a person is to do now.
struct NextTrial {
    PlannedTrial
        planned;      ///< its seed is the plan's the first time, and another one each time it is done again
    int number = 0;   ///< TrialRecord::trial
    int attempts = 0; ///< so often it was begun before and has to be done again
    std::size_t left = 0;   ///< planned trials not done yet, this one among them
    bool break_due = false; ///< a break comes before it
    bool operator==(const NextTrial&) const = default;
};

/// What follows for one person: `plan` is from trials_of, `records` are theirs in the order in which they were done. A trial that
/// is to be repeated comes again at once. Nothing: all are done. A break is due before a trial with as many counted ones done as
/// the experiment has between breaks, or a multiple of it; not before one that is done again.
std::optional<NextTrial> next_trial(const Experiment& experiment, std::span<const PlannedTrial> plan,
                                    std::span<const TrialRecord> records);

/// What is known of a trial before it is done: participant, number, condition, repetition, training, seed.
TrialRecord begun_record(const NextTrial& next, int participant);

/// Whether it is the record of that trial: its number, condition, repetition, training and seed.
bool is_of(const NextTrial& next, const TrialRecord& record);

/// The number (TrialRecord::trial) of the first record that is not what was planned: another condition, seed or number, or one too
/// many. Nothing: all are.
std::optional<int> first_unplanned(const Experiment& experiment, std::span<const PlannedTrial> plan,
                                   std::span<const TrialRecord> records);

} // namespace tp
