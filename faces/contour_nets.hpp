// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/crop.hpp"
#include "faces/landmarks.hpp"

#include <opencv2/dnn/dnn.hpp>

namespace tp {

/// Our own nets: one sees the whole face and places all points, twice; then one looks closely at each eye
/// (the left one in a mirror), one at the mouth and one at the outline, each in a window that fits it.
class ContourNets : public LandmarkModel {
public:
    ContourNets();
    std::optional<Landmarks> locate(const cv::Mat& picture, const Detection& face) override;

private:
    std::optional<std::vector<Vec2>> points_in(cv::dnn::Net& net, const cv::Mat& picture,
                                               const CropFrame& frame, int size);

    cv::dnn::Net face_, eye_, mouth_, outline_;
};

} // namespace tp
