// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/face.hpp"

#include <opencv2/core/mat.hpp>

namespace tp {

/// Why nobody should guess from a face who it is. Age is none of the reasons: it is not guessed.
enum class Unfit {
    no,          ///< it is fit
    no_contours, ///< an eye or the mouth is missing
    too_small,   ///< the eyes' middles are less than smallest_eyes_px apart
    cut_off,     ///< it leaves the picture
    in_profile,  ///< turned to the side so far that half of it is not seen
    covered,     ///< an eye or the mouth is guessed, since something may lie before it
    blurred
};

inline constexpr double smallest_eyes_px = 11.5; ///< a face of 34 px

/// The first reason that holds, of a face in an upright 8-bit BGR picture.
Unfit unfit_for_guessing(const cv::Mat& picture, const Face& face);

/// How sharp what face_square has made is, 0 … 1: the share of its steps of brightness that goes when it is blurred a
/// little more. Neither light nor contrast counts.
double sharpness(const cv::Mat& square);

} // namespace tp
