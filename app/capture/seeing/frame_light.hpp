// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <opencv2/core/mat.hpp>

#include <optional>
#include <vector>

namespace tp {

/// Mean of what is inside the middle of a face's box, 0 black … 1 white (luma as the camera gives it); nothing where that is
/// beside the picture. `grey`: 8-bit; places are shares of it.
std::optional<double> brightness_of(const cv::Mat& grey, const Rect& face);

/// Mean of what is beside all faces and the hair round them; nothing where that is less than a tenth of the picture.
std::optional<double> brightness_beside(const cv::Mat& grey, const std::vector<Rect>& faces);

} // namespace tp
