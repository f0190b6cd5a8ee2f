// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/transform.hpp"
#include "faces/base/detection.hpp"

#include <opencv2/core/mat.hpp>

namespace tp {

/// A face with its surroundings at a size at which it can be looked at quickly.
struct Shrunk {
    cv::Mat pixels;    ///< 8-bit BGR; of a picture that was not shrunk the picture itself
    Detection face;    ///< in these pixels
    Affine to_picture; ///< from these pixels to those of the picture

    /// Picture px per px.
    double scale() const { return to_picture.linear[0][0]; }
};

/// The part of the picture within one and a half sizes of the face's centre, shrunk by the largest whole
/// number that leaves the face at least `large_enough_px` large (areas averaged); the picture as it is where
/// that number is 1. So the pixels of a large face are read once and not by every look at it.
Shrunk shrunk_around(const cv::Mat& picture, const Detection& face, double large_enough_px);

} // namespace tp
