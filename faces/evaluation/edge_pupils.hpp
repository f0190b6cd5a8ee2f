// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/base/landmarks.hpp"
#include "faces/evaluation/edge_lessons.hpp"
#include "faces/evaluation/placed_truth.hpp"

#include <array>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace tp {

/// Lines that two models saw in a portrait, and contours that count as true there.
struct LinedPortrait {
    std::vector<cv::Mat> views;    ///< 8-bit BGR: as it is, noisy, blurred
    std::array<FaceLines, 2> seen; ///< by the embedded nets, by the face mesh
    std::vector<Contour> truth;
};

/// One person of whom edges are learned: `neutral` as hands placed its contours, `smiling` as the mesh saw
/// it, of which only the inner lip counts.
struct EdgePupil {
    LinedPortrait neutral, smiling;
    EdgeLessons lessons; ///< from all views of both portraits and both models' lines

    bool smiles_openly() const;
};

/// The people of `portraits` (neutral, "NNN_03.jpg"; the smile is "NNN_08.jpg" beside it) who are not
/// `held_out`, in their order. An error where a photo is missing or a model sees no face in it, and where
/// nobody is left.
Result<std::vector<EdgePupil>> edge_pupils(const std::vector<PlacedPortrait>& portraits,
                                           const std::set<std::string>& held_out, LandmarkModel& nets,
                                           LandmarkModel& mesh);

} // namespace tp
