// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/contour.hpp"
#include "faces/edges/edge_look.hpp"
#include "faces/evaluation/place_choice.hpp"
#include "faces/pieces/face_lines.hpp"

#include <opencv2/core/mat.hpp>

#include <array>
#include <optional>
#include <vector>

namespace tp {

inline constexpr int edge_features = 8; ///< slopes and bends of brightness and redness, as in EdgeLook

/// The weights of a look in the order of its members (edge_features × 1), and back.
cv::Mat1d weights_of(const EdgeLook& look);
EdgeLook look_with(const cv::Mat1d& weights, double stray, double bend);

/// For each kind of edge where it was found along the normals of lines: what the weights are learned from.
using EdgeLessons = std::array<std::vector<PlaceChoice>, edge_kind_count>;

/// Where the straight line through `place` in `direction` (unit length) crosses `line`: the crossing nearest
/// to `place`, in px along `direction`. Nothing where it does not cross.
std::optional<double> crossing(const std::vector<Vec2>& line, Vec2 place, Vec2 direction);

/// An eye or a lip as placed by hand, whose second corner is half way round: from one corner over the upper
/// edge to the other. Its lines run from the picture's left to its right.
Opening placed_opening(const Contour& contour);

/// What is seen across both lines of `start`, and where `truth` crosses their normals. Normals that it does
/// not cross within the reach of the profile teach nothing.
void learn(EdgeLessons& lessons, const cv::Mat& picture, const Opening& start, const Opening& truth,
           Vec2 down, double unit_px, EdgeKind lower, EdgeKind upper);

} // namespace tp
