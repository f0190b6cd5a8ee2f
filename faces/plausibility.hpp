// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/landmarks.hpp"

#include <vector>

namespace tp {

/// Mean distance between two placements of the same points, as a fraction of the extent of the first.
double disagreement(const std::vector<Vec2>& one, const std::vector<Vec2>& other);

/// The whole face was placed so differently the second time that no confidence can come of it.
bool is_unsteady(double between_passes);

/// 0 … 1, whether points that nets placed lie on a face: on one, looking again (`between_passes`) and looking
/// closely (`between_nets`, both a disagreement()) moves them little, and the features stand as in a face.
double confidence_of(const Landmarks& points, double between_passes, double between_nets);

} // namespace tp
