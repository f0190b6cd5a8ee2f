// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"
#include "faces/edges/edge_look.hpp"
#include "faces/edges/line_snap.hpp"

#include <opencv2/core/mat.hpp>

#include <array>
#include <vector>

namespace tp {

inline constexpr std::size_t edge_channels = 2; ///< brightness and redness, as in EdgeLook

/// What a picture shows across a line: each channel along the normal of each point.
struct EdgeProfile {
    std::size_t points = 0;
    std::array<std::vector<double>, edge_channels> channels; ///< points × samples, 0.2 % of the unit apart
};

/// Normals of a line (unit length, or 0 where it stands still), on that side on which `outwards` lies for
/// most of it.
std::vector<Vec2> normals_of(const std::vector<Vec2>& line, Vec2 outwards);

/// Looks across `line` (px, ≥ 3 points) in the 8-bit BGR `picture`, along the normals, of which `outwards`
/// chooses the side, at the full resolution of the picture, or at 0.2 % of `unit_px` where that is coarser.
/// `unit_px` is the distance between the outer eye corners. What is finer than `grain_percent` of it is
/// smoothed away first.
EdgeProfile edge_profile(const cv::Mat& picture, const std::vector<Vec2>& line, Vec2 outwards, double unit_px,
                         double grain_percent = 0.0);

/// What the profile says about an edge that looks like `look`, at offsets of up to 5 % of the unit. Linear in
/// the weights of `look`. Nothing is said about the first and the last point: a corner has no normal.
Evidence evidence_in(const EdgeProfile& profile, const EdgeLook& look);

} // namespace tp
