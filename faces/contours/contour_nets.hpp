// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/landmarks.hpp"
#include "faces/base/refinement_stage.hpp"
#include "faces/contours/crop.hpp"

#include <opencv2/dnn/dnn.hpp>

namespace tp {

/// The window of nets that see the outline: upright along the eyes, around eyes, mouth and outline of a face
/// with all of these.
CropFrame outline_frame(const Landmarks& face);

/// Our own nets: one sees the whole face and places all points, twice; then one looks closely at each eye
/// (the left one in a mirror), one at the mouth and one at the outline, each in a window that fits it. The
/// last look at the face and those at mouth and outline are taken at the mirror image too, so that a mirrored
/// picture has mirrored contours; the eyes are each other's mirror images anyway.
class ContourNets : public LandmarkModel {
public:
    /// Without the close looks there is nothing to verify a face by: whatever was detected is taken for one.
    explicit ContourNets(RefinementStage most = RefinementStage::close_looks);
    std::optional<Landmarks> locate(const cv::Mat& picture, const Detection& face) override;
    /// The close looks alone, from where another model sees the features, brows and all, of that face.
    /// `between_nets_px` is then how far they lie from those; the confidence is the other model's.
    std::optional<Landmarks> look_closely(const cv::Mat& picture, const Detection& face,
                                          const Landmarks& start);

private:
    using Points = std::vector<Vec2>;

    /// What a look at a window and its mirror image shows.
    struct BothWays {
        Points points;             ///< means of both, px of the picture
        std::vector<double> apart; ///< distance between both, px of the picture
    };

    std::optional<Landmarks> locate_in(const cv::Mat& picture, const Detection& face);
    std::optional<Landmarks> look_closely_in(const cv::Mat& picture, const Points& fine);
    Points answer(cv::dnn::Net& net, const cv::Mat& pixels);
    std::optional<Points> look(cv::dnn::Net& net, const cv::Mat& picture, const CropFrame& frame, int size);
    std::optional<BothWays> look_both_ways(cv::dnn::Net& net, const cv::Mat& picture, const CropFrame& frame,
                                           int size, std::size_t first);

    RefinementStage most_;
    cv::dnn::Net face_, eye_, mouth_, outline_;
};

} // namespace tp
