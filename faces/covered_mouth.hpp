// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/landmarks.hpp"
#include "faces/quality.hpp"

#include <array>

namespace tp {

/// Mean error of guessed lips, percent of the distance between the outer corners of the eyes: 16 people of whom nothing
/// was learned, their mouths covered (covered_mouths_are_said_and_guessed in tests/faces).
inline constexpr double guessed_lips_error_percent = 2.4;

/// What tells a covered mouth from one that is seen, the first one 1: how far two looks at its mirror images
/// and two nets differ about the lips, and how clear their least clear edges are.
inline constexpr std::size_t cover_sign_count = 5;
std::array<double, cover_sign_count> cover_signs(const QualitySigns& signs);

/// Whether these signs can tell at all: of a model that looks into a mirror, at a face large and clear
/// enough.
bool can_tell_cover(const QualitySigns& signs);

/// Whether something lies in front of the mouth, as far as can be told.
bool is_mouth_covered(const QualitySigns& signs);

/// Where the eyes' outer corners and three places of the outline lie, from which lips are guessed: 1 and six
/// lengths in the frame in which the right eye's outer corner is at −0.5 0 and the left one's at 0.5 0.
inline constexpr std::size_t lip_guide_count = 7;
std::array<double, lip_guide_count> lip_guides(const Landmarks& points);

/// The lips where people with such eyes and outlines have theirs, shut; everything else as it was. As it was
/// where the eyes are in one place.
Landmarks with_guessed_lips(Landmarks points);

} // namespace tp
