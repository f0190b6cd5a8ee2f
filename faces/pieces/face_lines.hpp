// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/landmarks.hpp"

#include <vector>

namespace tp {

/// The two edges of an eye or of a lip as dense lines, pixels of the picture. Both run from the corner of
/// `Landmarks` with index 0 to the other one and have as many points as each other.
struct Opening {
    std::vector<Vec2> lower, upper;

    /// Once round: the lower edge from corner to corner, then the upper one back; no point twice.
    std::vector<Vec2> around() const;
    /// Mean distance between points of the same index; 0 without points.
    double mean_gap() const;
};

/// The features of a face as dense lines, pixels of the picture.
struct FaceLines {
    Opening right_eye, left_eye, outer_lip, inner_lip;
    std::vector<Vec2> outline; ///< from ear to ear by the chin
};

/// Points per edge of an Opening, corners included, at equal distances.
inline constexpr std::size_t edge_points = 26;

/// Smooth lines through the points of `landmarks`.
FaceLines lines_through(const Landmarks& landmarks);

} // namespace tp
