// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/dnn/dnn.hpp>

namespace tp {

inline constexpr int detector_cell = 8; ///< px of a picture per answer of the embedded detector's net

/// What the net says of a picture (8-bit BGR): 1 × channels × rows × columns, an answer per `detector_cell`.
/// A grey border, as in the training, brings the picture's sides to multiples of 32 px. Takes 38 bytes a
/// pixel and keeps 32 of them in the net.
cv::Mat detector_answer(cv::dnn::Net& net, const cv::Mat& picture);

/// The same, keeping nothing: sides longer than `longest_part` px are cut into equal parts, each shown to a
/// net of its own with so much around it that its answers are those of the whole.
cv::Mat detector_answer_in_parts(const cv::Mat& picture, int longest_part);

} // namespace tp
