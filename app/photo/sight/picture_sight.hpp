// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/seen/seen_photo.hpp"
#include "faces/base/face.hpp"

#include <opencv2/core/mat.hpp>

#include <optional>

namespace tp {

/// What is measured of a picture, on a copy of at most 256 px.
struct PictureMeasures {
    double lightest = 0.0; ///< CIE L*, 0 … 100, that one pixel in ten of what is around people is above
    std::optional<double>
        around;            ///< median L* of what is neither face nor body; none where little of that is seen
    bool somebody = false; ///< a face was found
    double chroma = 0.0;   ///< CIE C*ab that one pixel in twenty is above
    double off_tone = 0.0; ///< how far such pixels lie from one tone (line through grey), CIE C*ab
    double blur = 0.0; ///< 0 sharp … 1 (Crété et al. 2007, "The blur effect"), of the sharpest quarter
    Colours most = Colours::many; ///< the colour that most of what is neither face nor body has
};

/// `picture`: 8-bit BGR, upright as the faces of `found` stand.
PictureMeasures measures_of(const cv::Mat& picture, const Extraction& found);

Light light_of(const PictureMeasures& measures);
Colours colours_of(const PictureMeasures& measures);
bool is_blurred(const PictureMeasures& measures);

} // namespace tp
