// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/study/expression.hpp"
#include "core/study/finger_touch.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tp {

/// A face whose expression is known.
struct ExpressionExample {
    std::string person;
    Expression shown = Expression::neutral;
    ExpressionCues cues{};
};

/// Which cues a finger has met, in the order of `Cue`.
using MetCues = std::array<bool, cue_count>;
inline constexpr MetCues all_cues_met = [] {
    MetCues all{};
    all.fill(true);
    return all;
}();

/// Names expressions by the cues alone: the likeliest where each cue is normally distributed about a mean of
/// each expression, independently of the others, with one spread for all expressions (a linear discriminant
/// with a shared diagonal covariance), and all expressions are as frequent. Ideal in that it uses every cue
/// as well as this model allows; what it confuses, the contours hardly tell apart.
class ExpressionObserver {
public:
    /// What one cue is like, percent of the eyes' distance.
    struct CueModel {
        double spread = 1.0; ///< standard deviation within an expression; > 0
        std::array<double, expression_count> means{};
    };
    using Model = std::array<CueModel, cue_count>; ///< in the order of `Cue`

    /// Means and spread of the examples. No spread is taken for smaller than what a finger cannot feel (0.5
    /// %, DESIGN §7). An error where there are fewer than two expressions, or no more faces than these.
    static Result<ExpressionObserver> learned_from(const std::vector<ExpressionExample>& examples);
    /// Learned from drawn people of all expressions, none of whom is a sample portrait
    /// (expression_observer.inc).
    static ExpressionObserver built_in();

    bool knows(Expression expression) const { return known_[static_cast<std::size_t>(expression)]; }
    /// Those of `wanted` that it knows.
    ExpressionChoices known_among(const ExpressionChoices& wanted) const;
    const Model& model() const { return model_; }

    /// How likely each of the choices is; 0 for what is no choice or not known, and all 0 where nothing is
    /// left. With `touch`, for cues that a finger felt so inexactly. Only cues that were met (`met`) tell anything.
    ExpressionShares judge(const ExpressionCues& cues, const ExpressionChoices& choices,
                           const std::optional<FingerTouch>& touch = std::nullopt,
                           const MetCues& met = all_cues_met) const;

private:
    Model model_;
    ExpressionChoices known_{};
};

} // namespace tp
