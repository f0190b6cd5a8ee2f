// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/seen/seen_photo.hpp"
#include "faces/base/face.hpp"

#include <opencv2/core/mat.hpp>

namespace tp {

/// What is seen on a photograph. `picture`: 8-bit BGR, upright as the faces of `found` stand (turned by
/// Extraction::turned_degrees). About 10 ms for 12 megapixels.
SeenPhoto look_at(const cv::Mat& picture, const Extraction& found);

} // namespace tp
