// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/corner_frame.hpp"

#include "core/geometry/flatten.hpp"
#include "core/geometry/polyline.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace tp {
namespace {

constexpr std::size_t points_of_a_contour = 240; ///< between which its moved lines are straight

CornerFrame frame_of(const std::vector<Vec2>& points, Vec2 across) {
    const auto [first, last] = std::minmax_element(points.begin(), points.end(), [across](Vec2 a, Vec2 b) {
        return glm::dot(a, across) < glm::dot(b, across);
    });
    const double width = length(*last - *first);
    return {*first, (*last - *first) / std::max(width, 1e-9), width};
}

EdgeLine edge_of(const Contour& contour, const CornerFrame& frame, bool is_lower) {
    std::vector<Vec2> uv, edge{Vec2(0.0), Vec2(frame.width, 0.0)};
    for (const Vec2 p : many_points(contour))
        uv.push_back(frame.of(p));
    const std::vector<bool> lower = on_lower_edge(uv);
    for (std::size_t i = 0; i < uv.size(); ++i)
        if (lower[i] == is_lower && frame.inside(uv[i].x))
            edge.push_back(uv[i]);
    return EdgeLine(std::move(edge));
}

} // namespace

Vec2 CornerFrame::of(Vec2 p) const {
    const Vec2 d = p - corner;
    return {glm::dot(d, across), glm::dot(d, Vec2(-across.y, across.x))};
}

Vec2 CornerFrame::back(Vec2 uv) const { return corner + uv.x * across + uv.y * Vec2(-across.y, across.x); }

EdgeLine::EdgeLine(std::vector<Vec2> uv) : points_(std::move(uv)) {
    std::sort(points_.begin(), points_.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
}

double EdgeLine::at(double u) const {
    const auto after =
        std::upper_bound(points_.begin(), points_.end(), u, [](double x, Vec2 p) { return x < p.x; });
    if (after == points_.begin() || after == points_.end())
        return 0.0;
    const Vec2 from = *(after - 1), to = *after;
    return from.y + (to.y - from.y) * (u - from.x) / std::max(to.x - from.x, 1e-9);
}

OpenedShape::OpenedShape(const Contour& contour, Vec2 way)
    : frame(frame_of(many_points(contour), way)), upper(edge_of(contour, frame, false)),
      lower(edge_of(contour, frame, true)) {}

std::vector<Vec2> many_points(const Contour& contour) {
    return resampled(flatten(contour), points_of_a_contour).points;
}

std::vector<bool> on_lower_edge(const std::vector<Vec2>& uv) {
    const auto by_u = [](Vec2 a, Vec2 b) { return a.x < b.x; };
    const Vec2 left = *std::min_element(uv.begin(), uv.end(), by_u);
    const Vec2 right = *std::max_element(uv.begin(), uv.end(), by_u);
    // Walked around from one corner to the other, the two edges are told apart by their mean height.
    const auto index_of = [&](Vec2 p) {
        return static_cast<std::size_t>(std::find(uv.begin(), uv.end(), p) - uv.begin());
    };
    std::vector<bool> first(uv.size(), false);
    double sum[2] = {0.0, 0.0};
    int count[2] = {0, 0};
    for (std::size_t i = index_of(left); i != index_of(right); i = (i + 1) % uv.size())
        first[i] = true;
    for (std::size_t i = 0; i < uv.size(); ++i) {
        sum[first[i]] += uv[i].y;
        ++count[first[i]];
    }
    const bool lower_is_first = sum[1] * count[0] > sum[0] * count[1];
    std::vector<bool> lower(uv.size());
    for (std::size_t i = 0; i < uv.size(); ++i)
        lower[i] = first[i] == lower_is_first && uv[i] != left && uv[i] != right;
    return lower;
}

Vec2 across_face(const Contour& right_eye, const Contour& left_eye) {
    const auto centre = [](const Contour& contour) { return bounds_of(flatten(contour).points).centre(); };
    const Vec2 eyes = centre(left_eye) - centre(right_eye);
    return eyes / std::max(length(eyes), 1e-9);
}

double smooth_step(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

void blend(cv::Mat& picture, const cv::Mat& share, cv::Scalar colour, double softness_px) {
    cv::Mat soft;
    cv::GaussianBlur(share, soft, {}, std::max(0.6, softness_px));
    picture.forEach<cv::Vec3f>([&](cv::Vec3f& p, const int* at) {
        const float part = soft.at<float>(at[0], at[1]);
        for (int c = 0; c < 3; ++c)
            p[c] += part * (static_cast<float>(colour[c]) - p[c]);
    });
}

} // namespace tp
