// SPDX-License-Identifier: Apache-2.0
#include "core/statistics/repeated_anova.hpp"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <utility>

namespace tp {
namespace {

constexpr double rounding = 1e-13; ///< of the largest number: what differs by less does not differ

/// Helmert's orthonormal contrasts of `count` numbers that lie `stride` apart, in place: the first becomes their sum by √count, each
/// further one says how that number differs from those before it.
void to_contrasts(double* first, std::size_t count, std::size_t stride) {
    double sum = *first;
    for (std::size_t i = 1; i < count; ++i) {
        double& value = first[i * stride];
        const auto before = static_cast<double>(i);
        const double contrast = (sum - before * value) / std::sqrt(before * (before + 1.0));
        sum += value;
        value = contrast;
    }
    *first = sum / std::sqrt(static_cast<double>(count));
}

/// Of one participant's cells, along each factor.
void to_contrasts(double* cells, const std::vector<Factor>& factors) {
    std::size_t all = 1;
    for (const Factor& factor : factors)
        all *= factor.levels.size();
    std::size_t stride = all;
    for (const Factor& factor : factors) {
        const std::size_t count = factor.levels.size();
        const std::size_t block = stride;
        stride /= count;
        for (std::size_t outer = 0; outer < all; outer += block)
            for (std::size_t inner = 0; inner < stride; ++inner)
                to_contrasts(cells + outer + inner, count, stride);
    }
}

/// Which factors a contrast is about, a bit each.
unsigned factors_of(std::size_t contrast, const std::vector<Factor>& factors) {
    unsigned bits = 0;
    for (std::size_t i = factors.size(); i-- > 0;) {
        const std::size_t count = factors[i].levels.size();
        if (contrast % count != 0)
            bits |= 1U << i;
        contrast /= count;
    }
    return bits;
}

/// What the participants' contrasts of one effect say.
struct Contrasts {
    std::size_t participants;
    std::vector<std::vector<double>> values; ///< contrast × participant, from their mean
    std::vector<double> means;

    double sum() const {
        double squares = 0.0;
        for (const double mean : means)
            squares += mean * mean;
        return static_cast<double>(participants) * squares;
    }
    double error_sum() const {
        double squares = 0.0;
        for (const auto& contrast : values)
            for (const double value : contrast)
                squares += value * value;
        return squares;
    }
    /// (tr S)² / (df tr S²), where S is the covariance of the contrasts.
    double epsilon() const {
        double squares = 0.0;
        for (std::size_t i = 0; i < values.size(); ++i)
            for (std::size_t j = 0; j <= i; ++j) {
                double covariance = 0.0;
                for (std::size_t k = 0; k < participants; ++k)
                    covariance += values[i][k] * values[j][k];
                squares += (i == j ? 1.0 : 2.0) * covariance * covariance;
            }
        const auto df = static_cast<double>(values.size());
        return std::clamp(error_sum() * error_sum() / (df * squares), 1.0 / df, 1.0);
    }
};

double f_above(double f, double df, double error_df) {
    return boost::math::cdf(boost::math::complement(boost::math::fisher_f(df, error_df), f));
}

void judge(WithinEffect& effect, const Contrasts& contrasts, double least_error) {
    if (effect.error_df < 1.0 || effect.error_sum <= least_error)
        return;
    effect.f = (effect.sum / effect.df) / (effect.error_sum / effect.error_df);
    effect.p = f_above(*effect.f, effect.df, effect.error_df);
    effect.epsilon = contrasts.epsilon();
    effect.p_spherical = f_above(*effect.f, *effect.epsilon * effect.df, *effect.epsilon * effect.error_df);
}

} // namespace

RepeatedAnova repeated_anova(const WithinMeans& means) {
    const std::size_t cells = means.cells(), participants = means.participants.size();
    std::vector<double> values = means.values;
    double largest = 0.0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < participants; ++i)
        to_contrasts(values.data() + i * cells, means.factors);

    std::vector<Contrasts> of_effect(std::size_t{1} << means.factors.size());
    for (std::size_t contrast = 0; contrast < cells; ++contrast) {
        Contrasts& effect = of_effect[factors_of(contrast, means.factors)];
        effect.participants = participants;
        std::vector<double>& row = effect.values.emplace_back();
        double mean = 0.0;
        for (std::size_t i = 0; i < participants; ++i) {
            row.push_back(values[i * cells + contrast]);
            mean += row.back() / static_cast<double>(participants);
        }
        for (double& value : row)
            value -= mean;
        effect.means.push_back(mean);
    }

    RepeatedAnova result{};
    result.participants_sum = of_effect[0].error_sum();
    const double least_error = std::pow(rounding * largest, 2.0) * static_cast<double>(values.size());
    double all_errors = result.participants_sum;
    for (unsigned bits = 1; bits < of_effect.size(); ++bits) {
        const Contrasts& contrasts = of_effect[bits];
        WithinEffect effect{};
        for (std::size_t i = 0; i < means.factors.size(); ++i)
            if (bits & (1U << i))
                effect.factors.push_back(i);
        effect.sum = contrasts.sum();
        effect.df = static_cast<double>(contrasts.values.size());
        effect.error_sum = contrasts.error_sum();
        effect.error_df = effect.df * (static_cast<double>(participants) - 1.0);
        judge(effect, contrasts, least_error);
        all_errors += effect.error_sum;
        result.effects.push_back(std::move(effect));
    }
    for (WithinEffect& effect : result.effects)
        if (effect.sum + all_errors > least_error)
            effect.eta_squared = effect.sum / (effect.sum + all_errors);
    std::ranges::stable_sort(result.effects, {},
                             [](const WithinEffect& effect) { return effect.factors.size(); });
    if (participants < 2)
        result.remark = "With one participant nothing can be said about others.";
    else if (std::ranges::any_of(result.effects, [](const WithinEffect& effect) { return !effect.f; }))
        result.remark =
            "Where the participants do not differ at all there is nothing to weigh an effect against.";
    return result;
}

std::string words_for(const WithinEffect& effect, const std::vector<Factor>& factors) {
    std::string words;
    for (const std::size_t factor : effect.factors)
        words += (words.empty() ? "" : " × ") + factors[factor].name;
    return words;
}

} // namespace tp
