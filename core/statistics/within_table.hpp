// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tp {

/// What differed between trials, and its levels, by the names that a reader sees: "stiffness", "0.1 N/mm".
struct Factor {
    std::string name;
    std::vector<std::string> levels;
};

/// One number for each participant in each cell (a combination of levels), and nothing missing.
struct WithinMeans {
    std::vector<Factor> factors;
    std::vector<std::string> participants;
    std::vector<double> values; ///< participants × cells; of a cell's levels the last factor's change first
    std::vector<std::string> left_out; ///< a sentence for each participant who is not among them

    std::size_t cells() const;
    const double* of(std::size_t participant) const { return values.data() + participant * cells(); }
};

/// The trials of an experiment in which every participant did everything (a within-participants design), in any order; several
/// of one participant in one cell count as their mean.
class WithinTable {
public:
    /// At least one factor; each with at least two levels.
    explicit WithinTable(std::vector<Factor> factors) : factors_(std::move(factors)) {}

    /// `levels` one index a factor. A value that is no finite number is as if the trial had not been.
    void add(const std::string& participant, const std::vector<std::size_t>& levels, double value);
    /// Who has no trial in some cell is left out, with a sentence. An error, in one sentence, where nobody remains.
    Result<WithinMeans> means() const;

private:
    struct Cell {
        double sum = 0.0;
        std::size_t trials = 0;
    };
    std::size_t cells() const;
    std::string words_for(std::size_t cell) const;

    std::vector<Factor> factors_;
    std::map<std::string, std::vector<Cell>> participants_;
};

} // namespace tp
