// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>

#include <opencv2/core/mat.hpp>

namespace tp {

/// BGR pixels as a picture for the screen, in memory of its own, with a longer side of at most `longest_px`. Any thread.
QImage small_picture(const cv::Mat& pixels, int longest_px);

} // namespace tp
