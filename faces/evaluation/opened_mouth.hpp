// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/evaluation/degraded.hpp"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace tp {

/// The portrait (8-bit BGR with its five contours) with its lower lip and jaw moved down until the mouth
/// stands open by `openness` > 0 of its width; what comes to sight is painted dark, for some `seed`s with
/// teeth or a tongue. The truth moves by the same rule, so it is as exact as it was. The portrait as it is
/// where a lip is missing.
///
/// Embedded nets have learned from mouths that training/warps.py opened in this way, other models have not.
Degraded with_opened_mouth(const cv::Mat& portrait, const std::vector<Contour>& truth, double openness,
                           unsigned seed);

} // namespace tp
