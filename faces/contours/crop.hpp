// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/transform.hpp"

#include <opencv2/core/mat.hpp>

namespace tp {

/// A square window on a picture, as a net wants to see a face or a feature. Pixels of the picture, in which
/// pixel (0, 0) covers 0 … 1 in both directions.
struct CropFrame {
    Vec2 centre{0.0};
    double side = 0.0;     ///< px; > 0
    double angle = 0.0;    ///< radians; of the window's x axis in the picture, x right, y down
    bool mirrored = false; ///< seen in a mirror: the window's x axis points the other way
};

/// What the window shows, and where its pixels lie.
struct Crop {
    cv::Mat pixels;    ///< size × size, 8-bit BGR
    Affine to_picture; ///< crop px → picture px
};

/// Finite, and neither so large nor so far away that there would be nothing to see.
bool is_sane(const CropFrame& frame, const cv::Mat& picture);

/// Cuts the window out of the picture at `size` × `size` px: averaging areas where it shrinks, interpolating
/// where it enlarges. What lies outside the picture repeats its border. The frame must be sane.
Crop take_crop(const cv::Mat& picture, const CropFrame& frame, int size);

} // namespace tp
