// SPDX-License-Identifier: Apache-2.0
#include "core/study/expression_table.hpp"

namespace tp {

void ExpressionTable::add(Expression shown, const ExpressionShares& answers) {
    const auto row = static_cast<std::size_t>(shown);
    ++faces_[row];
    for (std::size_t e = 0; e < expression_count; ++e)
        answers_[row][e] += answers[e];
}

double ExpressionTable::percent(Expression shown, Expression answered) const {
    const auto row = static_cast<std::size_t>(shown);
    return faces_[row] > 0 ? 100.0 * answers_[row][static_cast<std::size_t>(answered)] / faces_[row] : 0.0;
}

std::optional<double> ExpressionTable::percent_right(const ExpressionChoices& choices) const {
    double sum = 0.0;
    int rows = 0;
    for (const Expression shown : all_expressions)
        if (choices[static_cast<std::size_t>(shown)] && faces(shown) > 0) {
            sum += percent(shown, shown);
            ++rows;
        }
    return rows > 0 ? std::optional(sum / rows) : std::nullopt;
}

} // namespace tp
