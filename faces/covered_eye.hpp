// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/landmarks.hpp"
#include "faces/quality.hpp"

#include <array>
#include <optional>
#include <vector>

namespace tp {

/// Mean error of a guessed eye, percent of the distance between the outer corners of the eyes: people of whom
/// nothing was learned, one of their eyes covered (covered_eyes_are_said_and_guessed in tests/faces).
inline constexpr double guessed_eye_error_percent = 1.3;

/// Points of the other eye and its brow, the mouth, the nose and the outline, from which an eye is guessed.
inline constexpr std::size_t eye_guide_points = 19, points_of_an_eye = 16;
inline constexpr std::size_t eye_guide_count = 1 + 2 * eye_guide_points;

/// How an eye is guessed: the guides are moved, turned and scaled onto the mean ones; the guess is linear in
/// them there.
struct EyeGuesser {
    std::array<Vec2, eye_guide_points> mean_guides;
    double range[eye_guide_count][2]; ///< least and most of eye_guides
    /// Of eye_guides, for x and y of each point of the eye.
    double weights[2 * points_of_an_eye][eye_guide_count];
};
const EyeGuesser& learned_eye_guesser();

/// The points that guide to `eye`, as in a face whose left eye it is: those of the right one in a mirror.
/// Nothing where the model knows no brows or nose.
std::optional<std::array<Vec2, eye_guide_points>> eye_guide_places(const Landmarks& points, FeatureIndex eye);

/// The frame of a guess: from places in it, as in eye_guide_places, to those of the mean guides.
struct GuideFrame {
    Vec2 turn; ///< and scale, as a complex number
    Vec2 offset;

    GuideFrame(const std::array<Vec2, eye_guide_points>& guides,
               const std::array<Vec2, eye_guide_points>& mean);
    Vec2 into(Vec2 place) const;
    Vec2 back(Vec2 place) const;
};

/// 1 and the guides in their frame.
std::array<double, eye_guide_count> eye_guides(const std::array<Vec2, eye_guide_points>& places,
                                               const GuideFrame& frame);

/// Where people with such faces have that eye, like an eye of Landmarks; empty where nothing guides to it.
std::vector<Vec2> guessed_eye(const Landmarks& points, FeatureIndex eye,
                              const EyeGuesser& guesser = learned_eye_guesser());

/// Between the lids half way from corner to corner, of the distance of the corners, for an eye as of
/// Landmarks; negative where it is another model's.
double openness(const std::vector<Vec2>& eye);

/// Mean distance of an eye's points from its guess, percent of the distance between the outer corners;
/// negative where nothing guides to it.
double off_guess_percent(const Landmarks& points, FeatureIndex eye,
                         const EyeGuesser& guesser = learned_eye_guesser());

/// What tells a covered eye from one that is seen, the first one 1: how far two looks at mirror images and
/// two nets differ about it, how far it is from its guess, how clear the lids' edges are, and those of the
/// other eye.
inline constexpr std::size_t eye_cover_sign_count = 7;
std::array<double, eye_cover_sign_count> eye_cover_signs(const QualitySigns& signs, FeatureIndex eye);

/// Whether these signs can tell at all: of a model that looks into a mirror, at a face large enough and not
/// turned to the side, whose other eye is clear and open and whose mouth is not covered too. Of two shut eyes
/// one may be as hard to see as a covered one.
bool can_tell_eye_cover(const QualitySigns& signs, FeatureIndex eye);

/// Whether something lies in front of that eye, as far as can be told. Of two eyes at most one.
bool is_eye_covered(const QualitySigns& signs, FeatureIndex eye);

/// The guess in place of that eye; as it was where there is none.
Landmarks with_guessed_eye(Landmarks points, FeatureIndex eye);

} // namespace tp
