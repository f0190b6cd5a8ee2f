// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/evaluation/degraded.hpp"

#include <vector>

namespace tp {

/// The portrait (8-bit BGR with its five contours) as it is, in each way of degraded.hpp, with its mouth opened in
/// four widths and with its eyes half and wholly shut.
std::vector<Degraded> harder_ways(const cv::Mat& portrait, const std::vector<Contour>& truth, unsigned seed);

} // namespace tp
