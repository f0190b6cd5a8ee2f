// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/base/landmarks.hpp"
#include "faces/contours/contour_nets.hpp"

#include <opencv2/face/facemarkLBF.hpp>

#include <filesystem>
#include <memory>
#include <span>

namespace tp {

/// OpenCV's facemark by local binary features (Ren, Cao, Wei, Sun 2014) with the 68 points of iBUG's 300-W;
/// the file is the user's. It places a face wherever it is told that there is one, so our own nets judge
/// whether there is. Knows no irises, and of brows and nose only lines that are not contours.
class LbfModel : public LandmarkModel {
public:
    /// An error where the file is not such a facemark, or not one that is safe to use.
    static Result<std::unique_ptr<LandmarkModel>> load(const std::filesystem::path& file);
    /// `mean` are the 68 points of its mean shape, in halves of the box in which it looks, from its middle.
    LbfModel(cv::Ptr<cv::face::FacemarkLBF> facemark, std::vector<Vec2> mean);
    std::optional<Landmarks> locate(const cv::Mat& picture, const Detection& face) override;

private:
    std::optional<std::vector<Vec2>> look(const cv::Mat& picture, const Affine& from_mean);

    cv::Ptr<cv::face::FacemarkLBF> facemark_;
    std::vector<Vec2> mean_;
    ContourNets judge_;
};

/// Our features of the 68 points of iBUG, lids and lips rounded through them. What the points do not say is
/// left empty.
Landmarks features_of_68(std::span<const Vec2> points);

} // namespace tp
