// SPDX-License-Identifier: Apache-2.0
#include "core/statistics/within_table.hpp"

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

std::size_t cells_of(const std::vector<Factor>& factors) {
    std::size_t cells = 1;
    for (const Factor& factor : factors)
        cells *= factor.levels.size();
    return cells;
}

} // namespace

std::size_t WithinMeans::cells() const { return cells_of(factors); }
std::size_t WithinTable::cells() const { return cells_of(factors_); }

void WithinTable::add(const std::string& participant, const std::vector<std::size_t>& levels, double value) {
    std::vector<Cell>& cells_of_one = participants_[participant];
    cells_of_one.resize(cells());
    if (!std::isfinite(value))
        return;
    std::size_t cell = 0;
    for (std::size_t i = 0; i < factors_.size(); ++i)
        cell = cell * factors_[i].levels.size() + levels[i];
    cells_of_one[cell].sum += value;
    ++cells_of_one[cell].trials;
}

/// "stiffness 0.1 N/mm, path circle"
std::string WithinTable::words_for(std::size_t cell) const {
    std::string words;
    std::size_t rest = cell;
    for (std::size_t i = factors_.size(); i-- > 0;) {
        const std::size_t count = factors_[i].levels.size();
        std::string here = factors_[i].name;
        here.append(" ").append(factors_[i].levels[rest % count]).append(words.empty() ? "" : ", ");
        words.insert(0, here);
        rest /= count;
    }
    return words;
}

Result<WithinMeans> WithinTable::means() const {
    WithinMeans means;
    means.factors = factors_;
    for (const auto& [participant, cells_of_one] : participants_) {
        const auto missing = std::ranges::find(cells_of_one, std::size_t{0}, &Cell::trials);
        if (missing != cells_of_one.end()) {
            means.left_out.push_back("Participant " + participant + " is left out: there is no trial with " +
                                     words_for(static_cast<std::size_t>(missing - cells_of_one.begin())) +
                                     ".");
            continue;
        }
        means.participants.push_back(participant);
        for (const Cell& cell : cells_of_one)
            means.values.push_back(cell.sum / static_cast<double>(cell.trials));
    }
    if (means.participants.empty())
        return Error{means.left_out.empty()
                         ? "There are no trials."
                         : "No participant has done everything. " + means.left_out.front()};
    return means;
}

} // namespace tp
