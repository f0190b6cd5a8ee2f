// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/landmarks.hpp"

#include <opencv2/core/mat.hpp>

#include <array>

namespace tp {

/// How the skin inside the outline differs from that of the cheeks, the first one 1 (CIE L*a*b*): around the
/// chin, mean difference of lightness and of colour, and how much of it is darker and of another colour;
/// beside the cheeks, on the darker side the same.
inline constexpr std::size_t jaw_sign_count = 9;
/// Of a face in an 8-bit BGR picture. All 0 where its outline has fewer than 33 points or its eyes are in one
/// place.
std::array<double, jaw_sign_count> jaw_signs(const cv::Mat& picture, const Landmarks& face);

/// What lies before the jaw, as far as can be told: then the outline is a guess.
enum class JawCover { none, beard, hair };
JawCover jaw_cover(const std::array<double, jaw_sign_count>& signs);

} // namespace tp
