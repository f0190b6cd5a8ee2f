// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/contour.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace tp {

/// What the contours of a face alone tell of its expression. All are percent of the distance between the
/// outer corners of the eyes: about millimetres for a face that fills a 10-inch tablet (DESIGN §7). The
/// face's own frame is meant: "along" is the line through the centres of both eyes, "up" is across it, from
/// the mouth to the eyes. So none depends on place, size, roll or mirroring, nor on which way y runs.
enum class Cue {
    mouth_width,       ///< between the corners of the outer lips, along
    mouth_opening,     ///< between the inner lips in the middle of the mouth, up
    outer_corner_lift, ///< how far the outer lips' corners stand above half-way between their middles
    inner_corner_lift, ///< the same of the inner lips: of the line on which a shut mouth closes
    lip_height,        ///< thickness of both lips together in the middle of the mouth, up
    eye_opening,       ///< between the lids in the middle of an eye, up; mean of both eyes
    lid_slope, ///< how far the upper lid stands higher in its inner than in its outer quarter, against
               ///< the line through the eye's corners; mean of both eyes
    eye_slant, ///< how far the outer corner of an eye stands above its inner one; mean of both eyes
    chin_depth ///< how far the lowest place of the outline lies below the corners of the eyes
};

inline constexpr std::size_t cue_count = 9;

/// How a cue is called, and what a finger's errors do to it.
struct CueKind {
    const char* name;
    /// Standard deviation of the cue where each place that it is made of is felt with an independent error of
    /// standard deviation 1: the root of the summed squares of the places' weights.
    double noise_gain;
};

extern const std::array<CueKind, cue_count> cue_kinds;

/// In the order of `Cue`.
using ExpressionCues = std::array<double, cue_count>;

inline double& at(ExpressionCues& cues, Cue cue) { return cues[static_cast<std::size_t>(cue)]; }
inline double at(const ExpressionCues& cues, Cue cue) { return cues[static_cast<std::size_t>(cue)]; }

/// The cues of one face, from the contours "left_eye", "right_eye", "outer_lip", "inner_lip" and "outline"
/// among `contours`, in any unit and frame; lips and eyes are taken as closed. An error names the contour
/// that is missing, has no extent or lies where it cannot be in a face. What it gives is finite.
Result<ExpressionCues> expression_cues(const std::vector<Contour>& contours);

} // namespace tp
