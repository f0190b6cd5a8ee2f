// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/experiment/experiment.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tp {

/// One trial that a person is to do.
struct PlannedTrial {
    std::size_t condition = 0; ///< of the experiment; in training of Experiment::in_training()
    int repetition = 0;     ///< of the condition, from 0; of training always 0
    bool training = false;  ///< it does not count
    std::uint64_t seed = 0; ///< of everything that is random in it, such as where a shape lies
    bool operator==(const PlannedTrial&) const = default;
};

/// All trials of one person, training first. `participant` from 1; `seed` is the study's and recorded with it. The same numbers give
/// the same order on every computer.
std::vector<PlannedTrial> trials_of(const Experiment& experiment, int participant, std::uint64_t seed);

/// A row of a balanced Latin square of that many conditions: over as many rows (twice as many where the number is odd) each
/// condition stands equally often at each place and equally often right after each other one (Williams, Australian Journal of
/// Scientific Research A 2, 1949).
std::vector<std::size_t> latin_row(std::size_t conditions, std::size_t row);

} // namespace tp
