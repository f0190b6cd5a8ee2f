// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/contour_nets.hpp"
#include "faces/embedded_detector.hpp"
#include "faces/quality.hpp"

#include <opencv2/core/mat.hpp>

#include <array>
#include <optional>

namespace tp {

/// What the nets make of a face.
struct Sight {
    Landmarks points;
    QualitySigns signs;
};

/// Of the surest face; nothing where there is none.
std::optional<Sight> sight_of(EmbeddedDetector& detector, ContourNets& nets, const cv::Mat& picture);

template <std::size_t Count>
cv::Mat1d row_of(const std::array<double, Count>& numbers) {
    return cv::Mat1d(std::vector<double>(numbers.begin(), numbers.end()), true).reshape(1, 1);
}

/// Weights of `guides` (rows, the first 1) for places (rows of `y`), ridge regression in units of guides
/// divided by their deviation. The first weight of each place is not shrunk, and the others are those of
/// deviations from the mean.
cv::Mat1d fitted_places(const cv::Mat1d& guides, const cv::Mat1d& y, double ridge);

/// Weights of `signs` (rows, the first 1) for what is covered (1) or seen (0): logistic regression by
/// Newton's method. `prior`: covered ones to seen ones, as they are weighed.
cv::Mat1d fitted_cover(const cv::Mat1d& signs, const cv::Mat1d& y, double prior);

/// {a, b, …} to standard output.
void print_row(const cv::Mat1d& values);

} // namespace tp
