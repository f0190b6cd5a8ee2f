// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/face.hpp"
#include "faces/contours/hidden_jaw.hpp"
#include "faces/edges/edge_fit.hpp"

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
    bool has_second_opinion = false;                                                       ///< see Landmarks
    std::array<double, feature_count> between_models{}, between_close{};                   ///< see Landmarks
    std::array<double, 2> eye_openness{}; ///< of right and left eye, see openness()
    double outline_off_step = 0.0;        ///< see outline_step.hpp
    JawCover jaw = JawCover::none;        ///< where somebody asked, see hidden_jaw.hpp
    bool dark_glasses = false;            ///< before the eyes, where somebody asked, see dark_glasses.hpp
    EdgeReports edges;
};

/// `picture` (8-bit BGR) is the one in which they were found.
QualitySigns signs_of(const Landmarks& landmarks, const EdgeReports& edges, const cv::Mat& picture);

/// The numbers that predict a contour's error, the first one 1.
inline constexpr std::size_t predictor_count = 14;
std::array<double, predictor_count> predictors(const QualitySigns& signs, FeatureIndex feature);

/// What the signs say about a contour: the error that portraits with such signs had (log-linear in the
/// predictors, least squares on degraded portraits of people whom no training saw: faces/LEARNING.md), and what
/// is unusual about them.
ContourQuality quality_of(const QualitySigns& signs, FeatureIndex feature);

/// Whether our nets alone are enough: a face as clear, as large, as frontal and as exact as a portrait has
/// it. Where they are not, a second opinion is worth its time.
bool is_sure(const QualitySigns& signs);

} // namespace tp
