// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/edge_fit.hpp"
#include "faces/face.hpp"

#include <opencv2/core/mat.hpp>

#include <array>

namespace tp {

/// What the extraction of a face tells about how exact it is. Lengths are percent of `unit_px`.
struct QualitySigns {
    double unit_px = 0.0; ///< between the outer corners of the eyes
    /// −1 … 1, how much more of the face is seen on the left eye's side of the eyes than on the other: 0 in a
    /// frontal face. And the same of the eyes' widths.
    double turn = 0.0, eye_turn = 0.0;
    double confidence = 0.0; ///< of the landmarks, 0 … 1
    std::array<double, feature_count> between_passes{}, between_nets{}, between_mirrors{}; ///< see Landmarks
    /// Of right and left eye; negative: not known. See off_guess_percent.
    std::array<double, 2> eye_off_guess{-1.0, -1.0};
    /// Of right and left eye: between the lids half way, of the width; negative: not known.
    std::array<double, 2> eye_openness{-1.0, -1.0};
    double outline_off_step = 0.0; ///< see outline_step.hpp
    EdgeReports edges;
};

/// `picture` (8-bit BGR) is the one in which they were found.
QualitySigns signs_of(const Landmarks& landmarks, const EdgeReports& edges, const cv::Mat& picture);

/// Whether something lies in front of that feature, so that its contour is a guess from the rest of the face.
bool is_guessed(const QualitySigns& signs, FeatureIndex feature);

/// The numbers that predict a contour's error, the first one 1.
inline constexpr std::size_t predictor_count = 12;
std::array<double, predictor_count> predictors(const QualitySigns& signs, FeatureIndex feature);

/// What the signs say about a contour: the error that portraits with such signs had (log-linear in the
/// predictors, least squares on degraded portraits of people whom no training saw: faces/README.md), and what
/// is unusual about them.
ContourQuality quality_of(const QualitySigns& signs, FeatureIndex feature);

} // namespace tp
