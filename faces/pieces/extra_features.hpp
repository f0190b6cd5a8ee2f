// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/contour.hpp"
#include "faces/pieces/face_lines.hpp"

namespace tp {

/// Brows, nose and irises of a face as contours (names in `feature`), pixels; of those that the model knows.
/// An iris is what the lids leave of it; none where they hide nearly all. `tolerance` px as in fewest_pieces.
std::vector<Contour> extra_contours(const Landmarks& landmarks, const FaceLines& lines, double tolerance);

} // namespace tp
