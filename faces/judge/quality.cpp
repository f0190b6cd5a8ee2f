// SPDX-License-Identifier: Apache-2.0
#include "faces/judge/quality.hpp"

#include "faces/judge/covered.hpp"
#include "faces/judge/outline_step.hpp"

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

// Grounds of the reasons: what 34 portraits show as they are and degraded (evaluation/degraded.hpp).
constexpr double turned_from = 0.28;    ///< frontal below 0.25 (99 of 100), turned by 26° 0.38 (median)
constexpr double small_below_px = 30.0; ///< eyes apart 25 px: errors are half as large again as at 40 px
constexpr double blurred_below =
    0.15; ///< clarity: sharp 0.46 and more, blurred by 3 % 0.14 and less (99 of 100)
constexpr double faint_below = 0.35; ///< one mouth in ten
// Of faces about which our nets are believed: nine in ten studio portraits are within, six in ten photographs
// in the wild are not.
constexpr std::array<double, feature_count> sure_below_percent{0.6, 0.6, 1.0, 0.45, 1.5};
constexpr double sure_confidence = 0.97, sure_clarity = 0.25, sure_apart_percent = 4.0;
constexpr double error_floor_percent =
    0.05; ///< added to errors before the logarithm: small ones are all alike

/// Of the predictors, by calibrate_quality.
constexpr std::array<std::array<double, predictor_count>, feature_count> weights{{
#include "faces/judge/quality_weights.inc"
}};

double mean_of(const std::array<double, feature_count>& values) {
    double sum = 0.0;
    for (double v : values)
        sum += v;
    return sum / static_cast<double>(feature_count);
}

const EdgeReports::Pair* edges_of(const EdgeReports& edges, FeatureIndex feature) {
    switch (feature) {
    case at_right_eye:
        return &edges.right_eye;
    case at_left_eye:
        return &edges.left_eye;
    case at_outer_lip:
        return &edges.outer_lip;
    case at_inner_lip:
        return &edges.inner_lip;
    default:
        return nullptr;
    }
}

double mean_clarity(const EdgeReports& edges) {
    double sum = 0.0;
    for (const EdgeReports::Pair* p : {&edges.right_eye, &edges.left_eye, &edges.outer_lip, &edges.inner_lip})
        sum += p->lower.clarity + p->upper.clarity;
    return sum / 8.0;
}

enum { aside, small, blurred, covered, faint, beard, hair, dark_glasses };
constexpr const char* reason_words[] = {"turned to the side", "too small",         "blurred",
                                        covered_reason,       "its edge is faint", "a beard hides it",
                                        "hair hides it",      dark_glasses_reason};

std::vector<std::string> reasons(const QualitySigns& signs, FeatureIndex feature) {
    std::vector<std::string> words;
    if (std::abs(signs.turn) > turned_from)
        words.emplace_back(reason_words[aside]);
    const EdgeReports::Pair* lips = edges_of(signs.edges, at_outer_lip);
    if (is_eye(feature) && signs.dark_glasses)
        words.emplace_back(reason_words[dark_glasses]);
    else if (signs.unit_px < small_below_px)
        words.emplace_back(reason_words[small]);
    else if (mean_clarity(signs.edges) < blurred_below)
        words.emplace_back(reason_words[blurred]);
    else if (is_covered(signs, feature))
        words.emplace_back(reason_words[covered]);
    else if (feature == at_outline && signs.jaw != JawCover::none)
        words.emplace_back(reason_words[signs.jaw == JawCover::beard ? beard : hair]);
    else if (feature == at_outer_lip && lips->lower.clarity + lips->upper.clarity < faint_below)
        words.emplace_back(reason_words[faint]);
    return words;
}

} // namespace

QualitySigns signs_of(const Landmarks& points, const EdgeReports& edges, const cv::Mat& picture) {
    QualitySigns signs;
    signs.confidence = points.confidence;
    signs.has_second_opinion = points.has_second_opinion;
    signs.edges = edges;
    const Vec2 right = points.right_eye[0], left = points.left_eye[0];
    signs.unit_px = length(left - right);
    if (!(signs.unit_px > 0.0))
        return signs;
    signs.eye_openness = {openness(points.right_eye), openness(points.left_eye)};
    signs.outline_off_step = outline_off_step(picture, points.outline, signs.unit_px);
    const Vec2 across = (left - right) / signs.unit_px;
    const auto balance = [](double a, double b) {
        return std::clamp((a - b) / std::max(std::abs(a) + std::abs(b), 1e-9), -1.0, 1.0);
    };
    signs.turn = balance(glm::dot(points.outline.back() - left, across),
                         glm::dot(right - points.outline.front(), across));
    signs.eye_turn =
        balance(length(points.left_eye[eye_corner] - left), length(points.right_eye[eye_corner] - right));
    for (std::size_t f = 0; f < feature_count; ++f) {
        signs.between_passes[f] = 100.0 * points.between_passes_px[f] / signs.unit_px;
        signs.between_nets[f] = 100.0 * points.between_nets_px[f] / signs.unit_px;
        signs.between_mirrors[f] = 100.0 * points.between_mirrors_px[f] / signs.unit_px;
        signs.between_models[f] = 100.0 * points.between_models_px[f] / signs.unit_px;
        signs.between_close[f] = 100.0 * points.between_close_px[f] / signs.unit_px;
    }
    return signs;
}

std::array<double, predictor_count> predictors(const QualitySigns& signs, FeatureIndex feature) {
    const auto scale = [](double percent) { return std::log(0.3 + std::max(percent, 0.0)); };
    const auto unclear = [](double clarity) { return std::min(std::exp(-clarity), 4.0); };
    const EdgeReports::Pair* pair = edges_of(signs.edges, feature);
    const double lower = pair ? pair->lower.clarity : 0.0, upper = pair ? pair->upper.clarity : 0.0;
    return {1.0,
            scale(signs.between_passes[feature]),
            scale(signs.between_nets[feature]),
            scale(mean_of(signs.between_passes) + mean_of(signs.between_nets)),
            unclear(lower),
            unclear(upper),
            unclear(mean_clarity(signs.edges)),
            unclear(2.0 * std::min(lower, upper)),
            std::abs(signs.turn),
            std::abs(signs.eye_turn),
            -std::log(1.02 - std::clamp(signs.confidence, 0.0, 1.0)),
            feature == at_outline ? signs.outline_off_step : 0.0,
            signs.has_second_opinion ? 1.0 : 0.0,
            signs.has_second_opinion ? scale(signs.between_models[feature]) : 0.0};
}

ContourQuality quality_of(const QualitySigns& signs, FeatureIndex feature) {
    if (is_covered(signs, feature))
        return {is_eye(feature) ? covered_eye_error_percent : covered_mouth_error_percent,
                reasons(signs, feature)};
    const auto predictor = predictors(signs, feature);
    const auto& weight = weights[feature];
    double logarithm = 0.0;
    for (std::size_t i = 0; i < predictor_count; ++i)
        logarithm += weight[i] * predictor[i];
    const double error = std::exp(logarithm) - error_floor_percent;
    return {std::isfinite(error) ? std::clamp(error, 0.1, 99.0) : 99.0, reasons(signs, feature)};
}

bool is_sure(const QualitySigns& signs) {
    for (std::size_t f = 0; f < feature_count; ++f) {
        const ContourQuality quality = quality_of(signs, static_cast<FeatureIndex>(f));
        if (!quality.reasons.empty() || quality.expected_error_percent > sure_below_percent[f] ||
            std::max(signs.between_passes[f], signs.between_nets[f]) > sure_apart_percent)
            return false;
    }
    const EdgeReports& edges = signs.edges;
    return signs.confidence >= sure_confidence && edges.right_eye.clearest() >= sure_clarity &&
           edges.left_eye.clearest() >= sure_clarity && edges.inner_lip.clearest() >= sure_clarity;
}

} // namespace tp
