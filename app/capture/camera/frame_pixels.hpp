// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QVideoFrame>
#include <QVideoFrameFormat>

#include <opencv2/core/mat.hpp>

namespace tp {

/// Frames of this form become pixels.
bool is_read(QVideoFrameFormat::PixelFormat form);

/// The frame as 8-bit BGR, upright and not mirrored, in memory of its own; empty where it cannot be read. Any thread.
cv::Mat upright_pixels(QVideoFrame frame);

} // namespace tp
