// SPDX-License-Identifier: Apache-2.0
#include "faces/judge/covered.hpp"

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double least_eyes_apart_px = 30.0; ///< eyes apart; below, nothing about a face is clear
constexpr double open_eye = 0.15;             ///< openness; what covers a less open eye is its lids

#include "faces/judge/covered_weights.inc"

double of_feature(const std::array<double, feature_count>& percent, FeatureIndex feature) {
    const double value =
        is_eye(feature) ? percent[feature] : 0.5 * (percent[at_outer_lip] + percent[at_inner_lip]);
    return std::log(0.3 + std::max(0.0, value));
}

double bounded(double clarity) { return std::clamp(clarity, -0.5, 1.0); }

} // namespace

std::array<double, cover_sign_count> cover_signs(const QualitySigns& signs, FeatureIndex feature) {
    const EdgeReports& edges = signs.edges;
    const EdgeReports::Pair& here = feature == at_right_eye  ? edges.right_eye
                                    : feature == at_left_eye ? edges.left_eye
                                                             : edges.inner_lip;
    const double eyes = 0.5 * (edges.right_eye.clearest() + edges.left_eye.clearest());
    const double elsewhere = feature == at_right_eye  ? edges.left_eye.clearest()
                             : feature == at_left_eye ? edges.right_eye.clearest()
                                                      : eyes;
    return {1.0,
            of_feature(signs.between_models, feature),
            of_feature(signs.between_close, feature),
            of_feature(signs.between_nets, feature),
            of_feature(signs.between_mirrors, feature),
            bounded(here.faintest()),
            bounded(here.clearest()),
            bounded(elsewhere),
            std::abs(signs.turn),
            is_eye(feature) ? std::min(signs.eye_openness[feature], 0.3) : 0.0};
}

bool can_tell_cover(const QualitySigns& signs, FeatureIndex feature) {
    return feature != at_outline && signs.has_second_opinion && signs.unit_px >= least_eyes_apart_px;
}

bool is_covered(const QualitySigns& signs, FeatureIndex feature) {
    if (is_eye(feature) && signs.dark_glasses)
        return true;
    if (!can_tell_cover(signs, feature) || (is_eye(feature) && signs.eye_openness[feature] < open_eye))
        return false;
    const auto sign = cover_signs(signs, feature);
    const auto& weights = is_eye(feature) ? eye_cover_weights : mouth_cover_weights;
    double evidence = 0.0;
    for (std::size_t i = 0; i < cover_sign_count; ++i)
        evidence += weights[i] * sign[i];
    return evidence > 0.0;
}

} // namespace tp
