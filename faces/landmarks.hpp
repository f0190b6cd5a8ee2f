// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/detector.hpp"

#include <opencv2/core/mat.hpp>

#include <optional>
#include <vector>

namespace tp {

/// Points along the features of one face, pixels of the picture (pixel (0, 0) covers 0 … 1).
struct Landmarks {
    /// 16 each: [0] outer corner, lower lid, [8] inner corner, upper lid.
    std::vector<Vec2> right_eye, left_eye;
    /// 20 each: [0] the corner on the side of the right eye, lower edge, [10] the other corner, upper edge.
    std::vector<Vec2> outer_lip, inner_lip;
    /// From the ear on the side of the right eye by the chin to the other ear.
    std::vector<Vec2> outline;
    /// 0 … 1, how much this looks like a face: below 0.5 it is none.
    double confidence = 0.0;
};

/// Index of the second corner of an eye and of a lip; the first is 0.
inline constexpr std::size_t eye_corner = 8;
inline constexpr std::size_t mouth_corner = 10;

/// Finds the features of a detected face.
class LandmarkModel {
public:
    virtual ~LandmarkModel() = default;
    /// Nothing where there is no face or the detection leads outside the picture or to points that are not
    /// finite. May throw cv::Exception; the extractor catches it.
    virtual std::optional<Landmarks> locate(const cv::Mat& picture, const Detection& face) = 0;
};

} // namespace tp
