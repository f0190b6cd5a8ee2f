// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

namespace tp {

/// For a picture that is wanted as it is.
cv::Size no_box();

/// The size in which a picture fits into `box`, no larger than it is. All sizes in px.
cv::Size fitted(cv::Size size, cv::Size box);

/// Areas averaged; itself where it has that size.
cv::Mat resized(const cv::Mat& picture, cv::Size size);

/// The most that a picture may be shrunk while it is decoded and still fill `box`: 1, 2, 4 or 8.
int shrink_to_fill(cv::Size size, cv::Size box);

} // namespace tp
