// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/transform.hpp"
#include "faces/base/detection.hpp"

#include <opencv2/core/mat.hpp>

#include <array>
#include <optional>
#include <vector>

namespace tp {

/// The features of a face in the order of arrays that hold something about each.
enum FeatureIndex : std::size_t {
    at_right_eye,
    at_left_eye,
    at_outer_lip,
    at_inner_lip,
    at_outline,
    feature_count
};
constexpr bool is_eye(FeatureIndex feature) { return feature == at_right_eye || feature == at_left_eye; }

/// The coloured ring of an eye; radius 0 where it is not known.
struct Iris {
    Vec2 centre{0.0};
    double radius = 0.0; ///< px
};

/// Points along the features of one face, pixels of the picture (pixel (0, 0) covers 0 … 1).
struct Landmarks {
    /// 16 each: [0] outer corner, lower lid, [8] inner corner, upper lid.
    std::vector<Vec2> right_eye, left_eye;
    /// 20 each: [0] the corner on the side of the right eye, lower edge, [10] the other corner, upper edge.
    std::vector<Vec2> outer_lip, inner_lip;
    /// From the ear on the side of the right eye by the chin to the other ear.
    std::vector<Vec2> outline;
    /// What not every model knows; empty where it does not. Brows, 10 each: [0] outer end, lower edge, [4]
    /// inner end, upper edge. Nose, 11: from the top of the wing on the side of the right eye below to the
    /// other one.
    std::vector<Vec2> right_brow, left_brow, nose;
    Iris right_iris, left_iris;
    /// 0 … 1, how much this looks like a face: below 0.5 it is none.
    double confidence = 0.0;
    /// How far a model that looks more than once moved each feature: mean over its points, px; 0 where it did
    /// not look again. `between_passes`: the same net from a better window; `between_nets`: one that looks
    /// closer; `between_mirrors`: the same net at the mirror image of the same window.
    std::array<double, feature_count> between_passes_px{}, between_nets_px{}, between_mirrors_px{};
    /// Whether another model was asked too (second_opinion.hpp), and how far its points of each feature lie
    /// from ours, and from those of our close looks that began at them: means, px.
    bool has_second_opinion = false;
    std::array<double, feature_count> between_models_px{}, between_close_px{};
};

/// The same in another frame, in which lengths are `scale` times as long.
void map_points(Landmarks& landmarks, const Affine& map, double scale);

/// Index of the second corner of an eye and of a lip; the first is 0.
inline constexpr std::size_t eye_corner = 8;
inline constexpr std::size_t mouth_corner = 10;

/// Between the lids half way from corner to corner, of the distance of the corners, for an eye as of
/// Landmarks: open ones have 0.25 and more, shut ones 0.15 and less (99 of 100 each). 0 where the corners are
/// in one place.
double openness(const std::vector<Vec2>& eye);

/// Finds the features of a detected face.
class LandmarkModel {
public:
    virtual ~LandmarkModel() = default;
    /// Nothing where there is no face or the detection leads outside the picture or to points that are not
    /// finite. May throw cv::Exception; the extractor catches it.
    virtual std::optional<Landmarks> locate(const cv::Mat& picture, const Detection& face) = 0;
};

} // namespace tp
