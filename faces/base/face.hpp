// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/contour.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace tp {

/// Names of a face's contours. Left and right are the person's own.
namespace feature {
inline constexpr const char* left_eye = "left_eye";
inline constexpr const char* right_eye = "right_eye";
inline constexpr const char* outer_lip = "outer_lip";
inline constexpr const char* inner_lip = "inner_lip";
inline constexpr const char* outline = "outline";
// Those that can be added (Face::extras).
inline constexpr const char* left_brow = "left_brow";
inline constexpr const char* right_brow = "right_brow";
inline constexpr const char* nose = "nose";
inline constexpr const char* left_iris = "left_iris";
inline constexpr const char* right_iris = "right_iris";
} // namespace feature

// Reasons for which something lies before a feature, so that its contour is a guess.
inline constexpr const char* covered_reason = "may be covered";
inline constexpr const char* dark_glasses_reason = "dark glasses hide it";

/// How exact one contour of a face is, as far as can be told without knowing the truth.
struct ContourQuality {
    double expected_error_percent = 0.0; ///< of the outer inter-ocular distance; see contour_error_percent
    std::vector<std::string> reasons;    ///< why it is larger than usual, "turned to the side"; may be empty
};

/// Whether a person is told that something lies before that feature.
inline bool is_said_hidden(const ContourQuality& quality) {
    return std::ranges::any_of(quality.reasons, [](const std::string& reason) {
        return reason == covered_reason || reason == dark_glasses_reason;
    });
}

/// One face of a photograph. All places in pixels of the upright picture: x right, y down.
struct Face {
    Rect box;           ///< the head without hair, as detected
    double score = 0.0; ///< 0 … 1, how sure the detector is
    std::vector<Contour>
        contours;        ///< the five of `feature`, lines and quadratic Béziers; the outline is open
    std::string problem; ///< why its contours may be wrong, in a sentence; empty: no reason known
    std::vector<ContourQuality> quality = {}; ///< one for each of `contours`
    std::vector<std::string> mended = {};     ///< names of those contours that a person placed or took away
    /// Brows, nose and irises, as far as the model knows them and they can be seen: only for those who ask for
    /// them, for more features hinder a finger (Lim, Yoo, Choi 2019).
    std::vector<Contour> extras = {};
};

/// How long each step took, milliseconds.
struct ExtractionTimes {
    double decode = 0.0;
    double detect = 0.0;
    double landmarks = 0.0;
    double edges = 0.0;
    double contours = 0.0;
};

/// What was found in one photograph.
struct Extraction {
    int width = 0;  ///< px, upright; 0 where the picture could not be decoded
    int height = 0; ///< px
    /// By how much the picture had to be turned clockwise, beyond what its file says, for its faces to stand
    /// upright: 0, 90, 180 or 270. Size and places are those of the turned picture.
    int turned_degrees = 0;
    ExtractionTimes milliseconds;
    std::vector<Face> faces; ///< the largest first
    std::string problem;     ///< why nothing, or nothing to rely on, was found; empty: none
};

} // namespace tp
