// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/landmarks.hpp"

#include <vector>

namespace tp {

/// Mean distance between two placements of the same points, as a fraction of the extent of the first.
double disagreement(const std::vector<Vec2>& one, const std::vector<Vec2>& other);

/// How much the looks of nets at the same place differ. On a face they differ little.
struct Steadiness {
    double between_passes = 0.0;  ///< disagreement() of looking again from a better window
    double between_nets = 0.0;    ///< disagreement() of looking closely
    double between_mirrors = 0.0; ///< mean distance to the look into a mirror, of the window's side
};

/// What was seen so far leaves a confidence below 0.5, whatever the looks to come say.
bool is_unsteady(const Steadiness& so_far);

/// 0 … 1, whether points that nets placed lie on a face: the looks agree, and the features stand as in one.
double confidence_of(const Landmarks& points, const Steadiness& steadiness);

} // namespace tp
