// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

namespace tp {

/// A soft face with its steps of brightness made steeper (an unsharp mask), as the net knows faces: what face_square has
/// made, 8-bit BGR, of the same size. The less sharp it is the more; a sharp face is given back as it is.
cv::Mat sharpened_where_soft(const cv::Mat& square);

} // namespace tp
