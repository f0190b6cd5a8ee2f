// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/judge/quality.hpp"

#include <array>

namespace tp {

/// Mean errors of what is covered, percent of the distance between the outer corners of the eyes: it is drawn
/// where the face mesh sees it, and this is how far that was off at people of whom nothing was learned
/// (covered_features_are_said in tests/faces).
inline constexpr double covered_eye_error_percent = 1.1, covered_mouth_error_percent = 2.2;

/// What tells a feature that something covers from one that is seen, the first one 1: how far the nets differ
/// about it from the mesh, close looks from where they began, looks at mirror images from each other, how
/// clear its edges are and those of the rest of the face, and how far the face is turned.
inline constexpr std::size_t cover_sign_count = 10;
/// `feature`: an eye, or a lip, which stands for the mouth.
std::array<double, cover_sign_count> cover_signs(const QualitySigns& signs, FeatureIndex feature);

/// Whether these signs can tell at all: of eyes and lips of a face that the mesh has seen too, large enough
/// to be clear.
bool can_tell_cover(const QualitySigns& signs, FeatureIndex feature);

/// Whether something lies in front of that feature, as far as can be told: hair, a hand, dark glasses.
bool is_covered(const QualitySigns& signs, FeatureIndex feature);

} // namespace tp
