// SPDX-License-Identifier: Apache-2.0
#include "faces/pieces/face_lines.hpp"

#include "core/geometry/flatten.hpp"
#include "faces/pieces/contour_fit.hpp"

namespace tp {
namespace {

constexpr std::size_t outline_points = 41;

std::vector<Vec2> dense(const std::vector<Vec2>& points, std::size_t count) {
    const Polyline line = flatten(fit_contour({}, points, false), {0.02, 2.0});
    if (line.points.empty()) // all in one place
        return std::vector<Vec2>(count, points.front());
    return resampled(line, count).points;
}

Opening opening(const std::vector<Vec2>& around, std::size_t corner) {
    const std::vector<Vec2> lower(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(corner) + 1);
    std::vector<Vec2> upper{around[0]};
    upper.insert(upper.end(), around.rbegin(), around.rend() - static_cast<std::ptrdiff_t>(corner));
    return {dense(lower, edge_points), dense(upper, edge_points)};
}

} // namespace

std::vector<Vec2> Opening::around() const {
    std::vector<Vec2> points = lower;
    points.insert(points.end(), upper.rbegin() + 1, upper.rend() - 1);
    return points;
}

double Opening::mean_gap() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < lower.size(); ++i)
        sum += length(lower[i] - upper[i]);
    return lower.empty() ? 0.0 : sum / static_cast<double>(lower.size());
}

FaceLines lines_through(const Landmarks& landmarks) {
    return {opening(landmarks.right_eye, eye_corner), opening(landmarks.left_eye, eye_corner),
            opening(landmarks.outer_lip, mouth_corner), opening(landmarks.inner_lip, mouth_corner),
            dense(landmarks.outline, outline_points)};
}

} // namespace tp
