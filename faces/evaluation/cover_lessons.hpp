// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/contours/second_opinion.hpp"
#include "faces/detect/embedded_detector.hpp"
#include "faces/judge/quality.hpp"

#include <opencv2/core/mat.hpp>

#include <array>
#include <optional>

namespace tp {

/// Our nets and a second opinion about whatever they say.
struct Eyewitness {
    EmbeddedDetector detector;
    ContourNets nets;
    SecondOpinion second{nets};
};

/// What both make of a face.
struct Sight {
    Opinions opinions;
    QualitySigns signs;
};

/// Of the surest face; nothing where there is none.
std::optional<Sight> sight_of(Eyewitness& eyewitness, const cv::Mat& picture);

template <std::size_t Count>
cv::Mat1d row_of(const std::array<double, Count>& numbers) {
    return cv::Mat1d(std::vector<double>(numbers.begin(), numbers.end()), true).reshape(1, 1);
}

/// Weights of `signs` (rows, the first 1) for what is covered (1) or seen (0): logistic regression by
/// Newton's method. `prior`: covered ones to seen ones, as they are weighed.
cv::Mat1d fitted_cover(const cv::Mat1d& signs, const cv::Mat1d& y, double prior);

/// The least evidence (signs times `weights`) that at most `share` of the rows with a 0 in `y` exceed.
double threshold_for(const cv::Mat1d& signs, const cv::Mat1d& y, const cv::Mat1d& weights, double share);

/// {a, b, …} to standard output.
void print_row(const cv::Mat1d& values);

} // namespace tp
