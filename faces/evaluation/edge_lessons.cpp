// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/edge_lessons.hpp"

#include "core/geometry/polyline.hpp"
#include "faces/edges/edge_profile.hpp"

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr std::size_t placed_points = 101; ///< corners are cut by less than hands tremble
constexpr int features = edge_features;

/// Pointers to the weights of a look, in the order of the features.
template <typename Look>
auto members(Look& look) {
    auto& [brightness, redness, stray, bend] = look;
    return std::array{&brightness.fine_slope,  &brightness.fine_bend, &brightness.coarse_slope,
                      &brightness.coarse_bend, &redness.fine_slope,   &redness.fine_bend,
                      &redness.coarse_slope,   &redness.coarse_bend};
}

void learn_line(std::vector<PlaceChoice>& lessons, const cv::Mat& picture, const std::vector<Vec2>& start,
                const std::vector<Vec2>& truth, Vec2 outwards, double unit_px, double grain_percent) {
    const EdgeProfile profile = edge_profile(picture, start, outwards, unit_px, grain_percent);
    // The evidence is linear in the weights: a look with one weight of 1 shows one feature.
    std::vector<Evidence> seen;
    for (int f = 0; f < features; ++f) {
        cv::Mat1d alone(features, 1, 0.0);
        alone(f) = 1.0;
        seen.push_back(evidence_in(profile, look_with(alone, 0.0, 0.0)));
    }
    const std::vector<Vec2> normals = normals_of(start, outwards);
    const Evidence& any = seen.front();
    const int places = static_cast<int>(any.offsets);
    for (std::size_t i = 1; i + 1 < start.size(); ++i) {
        const std::optional<double> place = crossing(truth, start[i], normals[i]);
        if (!place)
            continue;
        PlaceChoice choice{cv::Mat1d(places, features),
                           100.0 * *place / unit_px / any.step + 0.5 * (places - 1)};
        if (!(choice.taken >= 0.0 && choice.taken <= places - 1))
            continue;
        for (int k = 0; k < places; ++k)
            for (int f = 0; f < features; ++f)
                choice.seen(k, f) = seen[static_cast<std::size_t>(f)].at(i, static_cast<std::size_t>(k));
        lessons.push_back(std::move(choice));
    }
}

} // namespace

cv::Mat1d weights_of(const EdgeLook& look) {
    cv::Mat1d weights(features, 1);
    int f = 0;
    for (const double* member : members(look))
        weights(f++) = *member;
    return weights;
}

EdgeLook look_with(const cv::Mat1d& weights, double stray, double bend) {
    EdgeLook look{{}, {}, stray, bend};
    int f = 0;
    for (double* member : members(look))
        *member = weights(f++);
    return look;
}

std::optional<double> crossing(const std::vector<Vec2>& line, Vec2 place, Vec2 direction) {
    const Vec2 beside(-direction.y, direction.x);
    std::optional<double> nearest;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double a = glm::dot(line[i] - place, beside), b = glm::dot(line[i + 1] - place, beside);
        if (a == b || !(std::min(a, b) <= 0.0 && std::max(a, b) >= 0.0))
            continue;
        const double t = a / (a - b);
        const double at = glm::dot((1.0 - t) * line[i] + t * line[i + 1] - place, direction);
        if (!nearest || std::abs(at) < std::abs(*nearest))
            nearest = at;
    }
    return nearest;
}

Opening placed_opening(const Contour& contour) {
    Polyline upper, lower;
    const std::size_t corner = contour.pieces.size() / 2;
    for (std::size_t i = 0; i <= corner; ++i)
        upper.points.push_back(start_of(contour.pieces[i]));
    lower.points.push_back(upper.points.front());
    for (std::size_t i = contour.pieces.size(); i-- > corner;)
        lower.points.push_back(start_of(contour.pieces[i]));
    return {resampled(lower, placed_points).points, resampled(upper, placed_points).points};
}

void learn(EdgeLessons& lessons, const cv::Mat& picture, const Opening& start, const Opening& truth,
           Vec2 down, double unit_px, EdgeKind lower, EdgeKind upper) {
    learn_line(lessons[lower], picture, start.lower, truth.lower, down, unit_px, edge_grain_percent[lower]);
    learn_line(lessons[upper], picture, start.upper, truth.upper, -down, unit_px, edge_grain_percent[upper]);
}

} // namespace tp
