// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/base/landmarks.hpp"

#include <opencv2/dnn/dnn.hpp>

#include <filesystem>
#include <memory>

namespace tp {

/// The 478-point face mesh of MediaPipe's face landmarker v2, converted to ONNX (input 256 px RGB, outputs
/// `t473` points and `t472` presence); the file is the user's. The outline is the silhouette of the projected
/// mesh.
class MeshModel : public LandmarkModel {
public:
    /// An error where the file is not such a mesh.
    static Result<std::unique_ptr<LandmarkModel>> load(const std::filesystem::path& file);
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
