// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/landmarks.hpp"

#include <opencv2/dnn/dnn.hpp>

#include <utility>

namespace tp {

/// The 478-point face mesh of MediaPipe's face landmarker v2, converted to ONNX (input 256 px RGB, outputs
/// `t473` points and `t472` presence). The outline is the silhouette of the projected mesh.
class MeshModel : public LandmarkModel {
public:
    explicit MeshModel(cv::dnn::Net net) : net_(std::move(net)) {}
    std::optional<Landmarks> locate(const cv::Mat& picture, const Detection& face) override;

private:
    cv::dnn::Net net_;
};

/// `count` ≥ 2 points along the convex hull of `mesh`, below the line through the outer corners of the eyes,
/// from the right eye's side by the chin to the left eye's side, at equal distances. Empty where the hull is
/// degenerate.
std::vector<Vec2> silhouette_below_eyes(const std::vector<Vec2>& mesh, Vec2 right_corner, Vec2 left_corner,
                                        std::size_t count);

} // namespace tp
