// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include <vector>

namespace tp {

/// What is seen at each of several places, and at which of them the thing sought lies.
struct PlaceChoice {
    cv::Mat1d seen;     ///< places × features
    double taken = 0.0; ///< index of the place; between two places in general
};

/// Logarithm of the likelihood with its derivatives by the weights.
struct LogLikelihood {
    double value = 0.0;
    cv::Mat1d gradient;  ///< features × 1
    cv::Mat1d curvature; ///< features × features, negative semidefinite: the likelihood is concave
};

/// How likely the choices are where the logarithm of the likelihood of a place is, up to a constant, the sum
/// of what is seen there times `weights` (features × 1): the conditional logit (McFadden 1974). A choice
/// between two places counts for both, for each as near as it lies. Choices that cannot be judged, because
/// they lie beyond the places or something seen is not finite, are left out.
LogLikelihood log_likelihood(const std::vector<PlaceChoice>& choices, const cv::Mat1d& weights);

/// The weights that maximise the logarithm of the likelihood less half of `ridge` times their squares, each
/// in units of what one deviation of its feature within a choice does (Newton's method, halved steps).
/// `ridge` > 0 keeps weights finite where places are told apart without error, and 0 where nothing speaks.
cv::Mat1d likeliest_weights(const std::vector<PlaceChoice>& choices, int features, double ridge);

} // namespace tp
