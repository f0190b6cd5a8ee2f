// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/contour.hpp"

#include <opencv2/core/mat.hpp>

#include <string>
#include <vector>

namespace tp {

/// A portrait made harder, and where its contours are then.
struct Degraded {
    std::string how; ///< "blur 4 %"
    cv::Mat picture; ///< 8-bit BGR
    std::vector<Contour> truth;
};

/// The portrait (8-bit BGR with its five contours) as it is and blurred, small, noisy, hardly compressed, lit
/// from the side, with an eye, the mouth or half of the face covered, rolled, and seen from the side (as far
/// as stretching one half and squeezing the other can show it). `seed` chooses what is left to chance.
std::vector<Degraded> degraded(const cv::Mat& portrait, const std::vector<Contour>& truth, unsigned seed);

} // namespace tp
