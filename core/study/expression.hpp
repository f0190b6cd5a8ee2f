// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace tp {

/// What a face can show: the four of Experiment III (Lim, Yoo, Choi 2019), and nothing in particular.
enum class Expression { smiling, surprised, sad, angry, neutral };

inline constexpr std::size_t expression_count = 5;
inline constexpr std::array<Expression, expression_count> all_expressions{
    Expression::smiling, Expression::surprised, Expression::sad, Expression::angry, Expression::neutral};

/// As files and tables name it: "smiling", "surprised", "sad", "angry", "neutral".
std::string_view name_of(Expression expression);
/// Nothing where no expression has that name.
std::optional<Expression> expression_named(std::string_view name);

/// Share of a set of answers that each expression has, in the order of `all_expressions`; together 1.
using ExpressionShares = std::array<double, expression_count>;

/// The expression with the largest share; the first of several.
Expression answer_of(const ExpressionShares& shares);

/// Which expressions may be answered.
using ExpressionChoices = std::array<bool, expression_count>;
/// The paper's participants chose among four; neutral was no answer.
inline constexpr ExpressionChoices paper_choices{true, true, true, true, false};
inline constexpr ExpressionChoices choices_with_neutral{true, true, true, true, true};

/// How often people named each of the paper's four faces rightly, percent (Experiment III, 16 faces).
std::optional<double> paper_percent_right(Expression expression);

} // namespace tp
