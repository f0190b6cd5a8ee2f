// SPDX-License-Identifier: Apache-2.0
#include "core/study/expression.hpp"

#include <algorithm>

namespace tp {

namespace {

constexpr std::array<std::string_view, expression_count> names{"smiling", "surprised", "sad", "angry",
                                                               "neutral"};

} // namespace

std::string_view name_of(Expression expression) { return names[static_cast<std::size_t>(expression)]; }

std::optional<Expression> expression_named(std::string_view name) {
    for (const Expression expression : all_expressions)
        if (name_of(expression) == name)
            return expression;
    return std::nullopt;
}

Expression answer_of(const ExpressionShares& shares) {
    return all_expressions[static_cast<std::size_t>(std::max_element(shares.begin(), shares.end()) -
                                                    shares.begin())];
}

std::optional<double> paper_percent_right(Expression expression) {
    switch (expression) {
    case Expression::smiling:
    case Expression::surprised:
        return 97.5;
    case Expression::sad:
    case Expression::angry:
        return 80.0;
    case Expression::neutral:
        break;
    }
    return std::nullopt;
}

} // namespace tp
