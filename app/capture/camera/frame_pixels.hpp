// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QVideoFrame>

#include <opencv2/core/mat.hpp>

namespace tp {

/// The frame as 8-bit BGR, upright and not mirrored, in memory of its own; empty where it cannot be read (bgr_of says when).
/// Any thread.
cv::Mat upright_pixels(QVideoFrame frame);

} // namespace tp
