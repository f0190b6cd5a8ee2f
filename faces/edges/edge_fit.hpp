// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/edges/edge_look.hpp"
#include "faces/pieces/face_lines.hpp"

#include <opencv2/core/mat.hpp>

#include <algorithm>

namespace tp {

/// What the fit of one edge has to say about it.
struct EdgeReport {
    double moved_percent =
        0.0;              ///< mean size of the displacement, of the distance between the outer eye corners
    double clarity = 0.0; ///< see clarity(); 0 where the picture shows no edge
};

/// Reports of the edges of a face.
struct EdgeReports {
    struct Pair {
        EdgeReport lower, upper;
        double clearest() const { return std::max(lower.clarity, upper.clarity); } ///< clarity of the clearer
        double faintest() const { return std::min(lower.clarity, upper.clarity); } ///< and of the other
    };
    Pair right_eye, left_eye, outer_lip, inner_lip;
};

/// `line` moved along its normals onto the edge that looks like `look`; where there is none it stays where it
/// is. At most 5 % of `unit_px`. `grain_percent`: as of edge_profile.
std::vector<Vec2> on_edge(const cv::Mat& picture, const std::vector<Vec2>& line, Vec2 outwards,
                          double unit_px, const EdgeLook& look, EdgeReport* report = nullptr,
                          double grain_percent = 0.0);

/// Lids and lips moved onto their edges in the picture. The outline stays: hair, collars and the shadow of
/// the chin have stronger edges than it. Faces whose eyes are less than 24 px apart stay as they are.
FaceLines on_edges(const cv::Mat& picture, FaceLines lines, EdgeReports* reports = nullptr,
                   const EdgeLooks& looks = edge_looks);

} // namespace tp
