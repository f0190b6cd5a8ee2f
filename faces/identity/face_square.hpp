// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"
#include "faces/base/face.hpp"

#include <opencv2/core/mat.hpp>

#include <optional>

namespace tp {

/// The places by which faces are laid upon each other: the middles of eyes and mouth, px of the picture.
struct FacePlaces {
    Vec2 right_eye{0.0}, left_eye{0.0}, mouth{0.0};
};
/// Of a face's contours; nothing where an eye or the outer lip is missing or not finite, or the eyes are in one
/// place.
std::optional<FacePlaces> face_places(const Face& face);

inline constexpr int face_square_px = 150; ///< side of what the net sees

/// The face as the net was trained to see it, 8-bit BGR: the similarity that brings eyes and mouth as near as it
/// can (least squares) to (0.33, 0.33), (0.67, 0.33) and (0.5, 0.74) of the square. Areas are averaged where it
/// shrinks; beyond the picture its border repeats. Nothing where that would be out of all proportion.
std::optional<cv::Mat> face_square(const cv::Mat& picture, const FacePlaces& places);

} // namespace tp
