// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/evaluation/degraded.hpp"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace tp {

/// The portrait (8-bit BGR with its five contours) with the lids of both eyes `shut` (0 … 1) of the way from
/// where they are to where they meet, at or a little above the lower one; the skin above is stretched, and
/// the lashes are a dark line. The truth moves by the same rule, so it is as exact as it was. The portrait as
/// it is where an eye is missing.
///
/// Embedded nets have learned from eyes that training/warps.py closed in this way, other models have not.
Degraded with_closed_eyes(const cv::Mat& portrait, const std::vector<Contour>& truth, double shut,
                          unsigned seed);

} // namespace tp
