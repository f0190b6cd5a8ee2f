// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/study/expression.hpp"

#include <optional>

namespace tp {

/// What faces were taken for: the confusion table of Experiment III.
class ExpressionTable {
public:
    /// One more face, and the shares of its answers.
    void add(Expression shown, const ExpressionShares& answers);

    int faces(Expression shown) const { return faces_[static_cast<std::size_t>(shown)]; }
    /// How often faces of `shown` were taken for `answered`, percent; 0 where there was no such face.
    double percent(Expression shown, Expression answered) const;
    /// Mean over those expressions shown that are among `choices`, each as heavy, percent; nothing where
    /// there are none.
    std::optional<double> percent_right(const ExpressionChoices& choices) const;

private:
    std::array<ExpressionShares, expression_count> answers_{};
    std::array<int, expression_count> faces_{};
};

} // namespace tp
