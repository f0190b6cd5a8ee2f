// SPDX-License-Identifier: Apache-2.0
#include "core/study/expression_observer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tp {

namespace {

constexpr double least_spread = 0.5; ///< percent

constexpr ExpressionObserver::Model built_in_model{{
#include "core/study/expression_observer.inc"
}};

} // namespace

Result<ExpressionObserver> ExpressionObserver::learned_from(const std::vector<ExpressionExample>& examples) {
    std::array<double, expression_count> faces{};
    for (const ExpressionExample& example : examples)
        ++faces[static_cast<std::size_t>(example.shown)];
    ExpressionObserver observer;
    double known = 0.0;
    for (std::size_t e = 0; e < expression_count; ++e) {
        observer.known_[e] = faces[e] > 0.0;
        known += observer.known_[e] ? 1.0 : 0.0;
    }
    const double freedom = static_cast<double>(examples.size()) - known;
    if (known < 2.0)
        return Error{"Faces of at least two expressions are needed to learn from."};
    if (!(freedom > 0.0))
        return Error{"More than one face of an expression is needed to learn from."};
    for (std::size_t i = 0; i < cue_count; ++i) {
        CueModel& cue = observer.model_[i];
        for (const ExpressionExample& example : examples) {
            const auto e = static_cast<std::size_t>(example.shown);
            cue.means[e] += example.cues[i] / faces[e];
        }
        double squares = 0.0;
        for (const ExpressionExample& example : examples) {
            const double off = example.cues[i] - cue.means[static_cast<std::size_t>(example.shown)];
            squares += off * off;
        }
        cue.spread = std::max(least_spread, std::sqrt(squares / freedom));
    }
    return observer;
}

ExpressionObserver ExpressionObserver::built_in() {
    ExpressionObserver observer;
    observer.model_ = built_in_model;
    observer.known_.fill(true);
    return observer;
}

ExpressionChoices ExpressionObserver::known_among(const ExpressionChoices& wanted) const {
    ExpressionChoices both{};
    for (std::size_t e = 0; e < expression_count; ++e)
        both[e] = wanted[e] && known_[e];
    return both;
}

ExpressionShares ExpressionObserver::judge(const ExpressionCues& cues, const ExpressionChoices& choices,
                                           const std::optional<FingerTouch>& touch,
                                           const MetCues& met) const {
    const ExpressionChoices open = known_among(choices);
    ExpressionShares shares{};
    double likeliest = -std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < expression_count; ++e) {
        for (std::size_t i = 0; i < cue_count; ++i) {
            if (!met[i])
                continue;
            const double spread = std::hypot(model_[i].spread, touch ? touch->noise_of(i) : 0.0);
            const double off = (cues[i] - model_[i].means[e]) / spread;
            shares[e] -= 0.5 * off * off; // the logarithm, up to what all have in common
        }
        if (open[e])
            likeliest = std::max(likeliest, shares[e]);
    }
    double sum = 0.0;
    for (std::size_t e = 0; e < expression_count; ++e) {
        shares[e] = open[e] ? std::exp(shares[e] - likeliest) : 0.0;
        sum += shares[e];
    }
    if (sum > 0.0)
        for (double& share : shares)
            share /= sum;
    return shares;
}

} // namespace tp
