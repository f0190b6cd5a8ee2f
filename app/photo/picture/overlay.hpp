// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/face.hpp"

#include <QImage>

#include <opencv2/core/mat.hpp>

namespace tp {

/// An 8-bit BGR picture as Qt holds it; a deep copy.
QImage to_image(const cv::Mat& picture);

/// The photograph with the contours of every face drawn on it, one colour a feature; at most `longest_px` on
/// its longer side.
QImage draw_overlay(const cv::Mat& picture, const Extraction& extraction, int longest_px = 1600);

} // namespace tp
