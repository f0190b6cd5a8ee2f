// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/place_choice.hpp"

#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr int most_steps = 50, most_halvings = 40;
constexpr double least_gain = 1e-10;     ///< of the penalised likelihood's logarithm, relative
constexpr double least_variance = 1e-12; ///< of a feature: one that never varies gets the weight 0

bool can_be_judged(const PlaceChoice& choice, int features) {
    return choice.seen.rows >= 2 && choice.seen.cols == features && choice.taken >= 0.0 &&
           choice.taken <= choice.seen.rows - 1 && cv::checkRange(choice.seen);
}

/// Of each feature: the mean over the choices of its variance among the places of one.
cv::Mat1d variances_within(const std::vector<PlaceChoice>& choices, int features) {
    cv::Mat1d sum(features, 1, 0.0);
    double count = 0.0;
    for (const PlaceChoice& choice : choices) {
        if (!can_be_judged(choice, features))
            continue;
        for (int f = 0; f < features; ++f) {
            cv::Scalar mean, deviation;
            cv::meanStdDev(choice.seen.col(f), mean, deviation);
            sum(f) += deviation[0] * deviation[0];
        }
        ++count;
    }
    for (double& variance : sum)
        variance = std::max(count > 0.0 ? variance / count : 0.0, least_variance);
    return sum;
}

} // namespace

LogLikelihood log_likelihood(const std::vector<PlaceChoice>& choices, const cv::Mat1d& weights) {
    const int features = weights.rows;
    LogLikelihood result{0.0, cv::Mat1d(features, 1, 0.0), cv::Mat1d(features, features, 0.0)};
    std::vector<double> chance;
    cv::Mat1d mean(1, features), scaled;
    for (const PlaceChoice& choice : choices) {
        if (!can_be_judged(choice, features))
            continue;
        const cv::Mat1d& seen = choice.seen;
        chance.resize(static_cast<std::size_t>(seen.rows));
        double most = -HUGE_VAL, sum = 0.0;
        for (int k = 0; k < seen.rows; ++k) {
            double& logarithm = chance[static_cast<std::size_t>(k)];
            logarithm = 0.0;
            for (int f = 0; f < features; ++f)
                logarithm += seen(k, f) * weights(f);
            most = std::max(most, logarithm);
        }
        const int below = std::min(static_cast<int>(choice.taken), seen.rows - 2);
        const double share = choice.taken - below;
        result.value += (1.0 - share) * chance[static_cast<std::size_t>(below)] +
                        share * chance[static_cast<std::size_t>(below) + 1] - most;
        for (double& value : chance)
            sum += value = std::exp(value - most);
        result.value -= std::log(sum);

        mean = 0.0;
        for (int k = 0; k < seen.rows; ++k)
            for (int f = 0; f < features; ++f)
                mean(f) += chance[static_cast<std::size_t>(k)] / sum * seen(k, f);
        for (int f = 0; f < features; ++f)
            result.gradient(f) += (1.0 - share) * seen(below, f) + share * seen(below + 1, f) - mean(f);
        for (int k = 0; k < seen.rows; ++k)
            for (int f = 0; f < features; ++f) {
                const double here = chance[static_cast<std::size_t>(k)] / sum * (seen(k, f) - mean(f));
                for (int g = 0; g <= f; ++g)
                    result.curvature(f, g) -= here * (seen(k, g) - mean(g));
            }
    }
    cv::completeSymm(result.curvature, true);
    return result;
}

cv::Mat1d likeliest_weights(const std::vector<PlaceChoice>& choices, int features, double ridge) {
    const cv::Mat1d price(ridge * variances_within(choices, features));
    const auto penalised = [&](const cv::Mat1d& weights) {
        LogLikelihood result = log_likelihood(choices, weights);
        result.value -= 0.5 * price.dot(weights.mul(weights));
        result.gradient -= price.mul(weights);
        result.curvature -= cv::Mat::diag(price);
        return result;
    };
    cv::Mat1d weights(features, 1, 0.0);
    LogLikelihood here = penalised(weights);
    for (int step = 0; step < most_steps; ++step) {
        cv::Mat1d direction;
        cv::solve(-here.curvature, here.gradient, direction, cv::DECOMP_CHOLESKY);
        const double before = here.value;
        double size = 1.0;
        for (int halving = 0; halving < most_halvings; ++halving, size *= 0.5) {
            const cv::Mat1d there(weights + size * direction);
            LogLikelihood next = penalised(there);
            if (next.value > before) {
                weights = there;
                here = next;
                break;
            }
        }
        if (here.value - before <= least_gain * std::abs(before))
            break;
    }
    return weights;
}

} // namespace tp
