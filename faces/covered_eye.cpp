// SPDX-License-Identifier: Apache-2.0
#include "faces/covered_eye.hpp"

#include "faces/covered_mouth.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace tp {
namespace {

constexpr double least_eyes_apart_px = 30.0; ///< eyes apart; below, nothing about a face is clear
/// Nets and mirrored looks that differ by less, percent, have seen an eye, were it a shut one: 2.1 and more
/// at covered eyes (99 of 100), 2.3 at seen ones (median).
constexpr double agreed_percent = 2.0;
constexpr double least_turned = 0.28; ///< beyond, the farther eye is neither clear nor where it is guessed
constexpr double clear_eye = 0.15;    ///< mean clarity of the lids; sharp portraits have 0.45 and more
/// Least openness of the other eye: open ones have 0.25 and more, shut ones 0.15 and less (99 of 100 each).
constexpr double open_eye = 0.19;
/// Covered eyes of those from whom it was learned have 0.58 and more, seen ones at most that.
constexpr double least_evidence = 0.5;

#include "faces/covered_eye_weights.inc"

std::complex<double> complex_of(Vec2 v) { return {v.x, v.y}; }
Vec2 place_of(std::complex<double> z) { return {z.real(), z.imag()}; }

const EdgeReports::Pair& lids_of(const QualitySigns& signs, FeatureIndex eye) {
    return eye == at_left_eye ? signs.edges.left_eye : signs.edges.right_eye;
}

FeatureIndex other_eye(FeatureIndex eye) { return eye == at_left_eye ? at_right_eye : at_left_eye; }

double clarity_of(const QualitySigns& signs, FeatureIndex eye) {
    const EdgeReports::Pair& lids = lids_of(signs, eye);
    return 0.5 * (lids.lower.clarity + lids.upper.clarity);
}

double evidence_of_cover(const QualitySigns& signs, FeatureIndex eye) {
    const auto sign = eye_cover_signs(signs, eye);
    double evidence = 0.0;
    for (std::size_t i = 0; i < eye_cover_sign_count; ++i)
        evidence += eye_cover_weights[i] * sign[i];
    return evidence;
}

} // namespace

const EyeGuesser& learned_eye_guesser() { return eye_guesser; }

std::optional<std::array<Vec2, eye_guide_points>> eye_guide_places(const Landmarks& points,
                                                                   FeatureIndex eye) {
    const bool left = eye == at_left_eye;
    const auto& seen = left ? points.right_eye : points.left_eye;
    const auto& brow = left ? points.right_brow : points.left_brow;
    if (seen.size() != points_of_an_eye || brow.size() != 10 || points.nose.size() != 11 ||
        points.outer_lip.size() != 20 || points.outline.size() != 33)
        return std::nullopt;
    std::array<Vec2, eye_guide_points> places;
    std::size_t count = 0;
    const auto add = [&](const std::vector<Vec2>& line, std::initializer_list<std::size_t> numbers) {
        for (const std::size_t i : numbers)
            places[count++] = left ? line[i] : Vec2(-line[i].x, line[i].y);
    };
    add(seen, {0, 4, 8, 12});
    add(brow, {0, 4, 7});
    if (left) {
        add(points.outer_lip, {0, 5, 10, 15});
        add(points.nose, {0, 5, 10});
        add(points.outline, {0, 8, 16, 24, 32});
    } else {
        add(points.outer_lip, {10, 5, 0, 15});
        add(points.nose, {10, 5, 0});
        add(points.outline, {32, 24, 16, 8, 0});
    }
    return places;
}

/// Least squares.
GuideFrame::GuideFrame(const std::array<Vec2, eye_guide_points>& guides,
                       const std::array<Vec2, eye_guide_points>& mean) {
    Vec2 from(0.0), to(0.0);
    for (std::size_t i = 0; i < eye_guide_points; ++i) {
        from += guides[i] / static_cast<double>(eye_guide_points);
        to += mean[i] / static_cast<double>(eye_guide_points);
    }
    std::complex<double> common = 0.0;
    double own = 0.0;
    for (std::size_t i = 0; i < eye_guide_points; ++i) {
        common += std::conj(complex_of(guides[i] - from)) * complex_of(mean[i] - to);
        own += std::norm(complex_of(guides[i] - from));
    }
    const auto map = common / own;
    turn = place_of(map);
    offset = to - place_of(map * complex_of(from));
}

Vec2 GuideFrame::into(Vec2 place) const { return place_of(complex_of(turn) * complex_of(place)) + offset; }
Vec2 GuideFrame::back(Vec2 place) const { return place_of(complex_of(place - offset) / complex_of(turn)); }

std::array<double, eye_guide_count> eye_guides(const std::array<Vec2, eye_guide_points>& places,
                                               const GuideFrame& frame) {
    std::array<double, eye_guide_count> guides{1.0};
    for (std::size_t i = 0; i < eye_guide_points; ++i) {
        const Vec2 p = frame.into(places[i]);
        guides[1 + 2 * i] = p.x;
        guides[2 + 2 * i] = p.y;
    }
    return guides;
}

std::vector<Vec2> guessed_eye(const Landmarks& points, FeatureIndex eye, const EyeGuesser& guesser) {
    const auto places = eye_guide_places(points, eye);
    if (!places)
        return {};
    const GuideFrame frame(*places, guesser.mean_guides);
    if (!(length(frame.turn) > 0.0)) // nor where all guides are in one place
        return {};
    auto guides = eye_guides(*places, frame);
    for (std::size_t g = 0; g < eye_guide_count; ++g) // a face unlike all counts as the most unlike one
        guides[g] = std::clamp(guides[g], guesser.range[g][0], guesser.range[g][1]);
    std::vector<Vec2> guess;
    for (std::size_t i = 0; i < points_of_an_eye; ++i) {
        Vec2 place(0.0);
        for (std::size_t g = 0; g < eye_guide_count; ++g)
            place += guides[g] * Vec2(guesser.weights[2 * i][g], guesser.weights[2 * i + 1][g]);
        place = frame.back(place);
        guess.emplace_back(eye == at_left_eye ? place.x : -place.x, place.y);
    }
    return guess;
}

double openness(const std::vector<Vec2>& eye) {
    if (eye.size() != points_of_an_eye)
        return -1.0;
    const double width = length(eye[8] - eye[0]);
    return width > 0.0 ? length(eye[4] - eye[12]) / width : 0.0;
}

double off_guess_percent(const Landmarks& points, FeatureIndex eye, const EyeGuesser& guesser) {
    const auto guess = guessed_eye(points, eye, guesser);
    const auto& found = eye == at_left_eye ? points.left_eye : points.right_eye;
    const double unit = length(points.left_eye[0] - points.right_eye[0]);
    if (guess.size() != found.size() || !(unit > 0.0))
        return -1.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < guess.size(); ++i)
        sum += length(found[i] - guess[i]);
    return 100.0 * sum / unit / static_cast<double>(guess.size());
}

std::array<double, eye_cover_sign_count> eye_cover_signs(const QualitySigns& signs, FeatureIndex eye) {
    const auto scale = [](double percent) { return std::log(0.3 + std::max(0.0, percent)); };
    const EdgeReports::Pair& lids = lids_of(signs, eye);
    const auto bounded = [](double clarity) { return std::clamp(clarity, -0.5, 1.0); };
    return {1.0,
            scale(signs.between_mirrors[eye]),
            scale(signs.between_nets[eye]),
            scale(signs.eye_off_guess[eye]),
            bounded(std::min(lids.lower.clarity, lids.upper.clarity)),
            bounded(std::max(lids.lower.clarity, lids.upper.clarity)),
            bounded(clarity_of(signs, other_eye(eye)))};
}

bool can_tell_eye_cover(const QualitySigns& signs, FeatureIndex eye) {
    return !is_mouth_covered(signs) && signs.between_mirrors[eye] > 0.0 && signs.eye_off_guess[eye] >= 0.0 &&
           signs.unit_px >= least_eyes_apart_px && std::abs(signs.turn) < least_turned &&
           clarity_of(signs, other_eye(eye)) > clear_eye && signs.eye_openness[other_eye(eye)] > open_eye;
}

bool is_eye_covered(const QualitySigns& signs, FeatureIndex eye) {
    if (!can_tell_eye_cover(signs, eye) ||
        signs.between_nets[eye] + signs.between_mirrors[eye] < agreed_percent)
        return false;
    const double here = evidence_of_cover(signs, eye);
    return here > least_evidence &&
           !(can_tell_eye_cover(signs, other_eye(eye)) && evidence_of_cover(signs, other_eye(eye)) >= here);
}

Landmarks with_guessed_eye(Landmarks points, FeatureIndex eye) {
    auto guess = guessed_eye(points, eye);
    if (!guess.empty())
        (eye == at_left_eye ? points.left_eye : points.right_eye) = std::move(guess);
    return points;
}

} // namespace tp
