// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/opened_mouth.hpp"

#include "core/geometry/flatten.hpp"
#include "core/geometry/polyline.hpp"
#include "faces/evaluation/contour_error.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace tp {
namespace {

constexpr std::size_t points_of_a_contour = 240; ///< between which its moved lines are straight

/// u along the line from one corner of the mouth to the other, v across it, down the face; px.
struct MouthFrame {
    Vec2 corner{0.0}, across{1.0, 0.0};

    Vec2 of(Vec2 p) const {
        const Vec2 d = p - corner;
        return {glm::dot(d, across), glm::dot(d, Vec2(-across.y, across.x))};
    }
    Vec2 back(Vec2 uv) const { return corner + uv.x * across + uv.y * Vec2(-across.y, across.x); }
};

/// v over u, 0 beyond both ends.
class Edge {
public:
    explicit Edge(std::vector<Vec2> points) : points_(std::move(points)) {
        std::sort(points_.begin(), points_.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
    }
    double at(double u) const {
        const auto after =
            std::upper_bound(points_.begin(), points_.end(), u, [](double x, Vec2 p) { return x < p.x; });
        if (after == points_.begin() || after == points_.end())
            return 0.0;
        const Vec2 from = *(after - 1), to = *after;
        return from.y + (to.y - from.y) * (u - from.x) / std::max(to.x - from.x, 1e-9);
    }

private:
    std::vector<Vec2> points_;
};

std::vector<Vec2> points_of(const Contour& contour) {
    return resampled(flatten(contour), points_of_a_contour).points;
}

double smooth_step(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The rule by which lower lip, jaw and neck move.
class OpenedLips {
public:
    OpenedLips(Edge upper, Edge lower, double width, double drop)
        : upper_(std::move(upper)), lower_(std::move(lower)), width_(width), drop_(drop) {}

    double top(double u) const { return upper_.at(u); }
    /// Of the lower lip's inner edge, before it moves.
    double bottom(double u) const { return std::max(lower_.at(u), top(u)); }
    double lip_drop(double u) const {
        const double away = 2.0 * u / width_ - 1.0;
        return drop_ * std::pow(std::clamp(1.0 - away * away, 0.0, 1.0), 0.6);
    }
    /// Of what lies on or below that edge: with the lip, further down with the jaw.
    double drop(double u, double v) const {
        const double away = (u - 0.5 * width_) / (1.25 * width_);
        const double with_jaw = smooth_step((v - bottom(u)) / (0.7 * width_));
        return lip_drop(u) * (1.0 - with_jaw) + drop_ * std::exp(-away * away) * with_jaw;
    }
    /// Where what is seen at (u, v) after the move was before.
    double before(double u, double v) const {
        double source = v - lip_drop(u);
        for (int round = 0; round < 8; ++round)
            source = v - drop(u, source);
        return source;
    }
    bool inside(double u) const { return u > 0.0 && u < width_; }
    double width() const { return width_; }

private:
    Edge upper_, lower_;
    double width_, drop_;
};

/// Whether a point of the contour lies on the lower part of a lip, between its corners.
std::vector<bool> on_lower_part(const std::vector<Vec2>& uv) {
    const auto by_u = [](Vec2 a, Vec2 b) { return a.x < b.x; };
    const Vec2 left = *std::min_element(uv.begin(), uv.end(), by_u);
    const Vec2 right = *std::max_element(uv.begin(), uv.end(), by_u);
    // Walked around from one corner to the other, the two parts are told apart by their mean height.
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

/// Share of `colour` where the mask is 1, its border softened.
void blend(cv::Mat& picture, const cv::Mat& mask, cv::Scalar colour, double softness) {
    cv::Mat soft;
    cv::GaussianBlur(mask, soft, {}, std::max(0.6, softness));
    picture.forEach<cv::Vec3f>([&](cv::Vec3f& p, const int* at) {
        const float share = soft.at<float>(at[0], at[1]);
        for (int c = 0; c < 3; ++c)
            p[c] += share * (static_cast<float>(colour[c]) - p[c]);
    });
}

cv::Mat opened(const cv::Mat& portrait, const MouthFrame& frame, const OpenedLips& mouth, cv::RNG& random) {
    const double width = mouth.width();
    const double teeth = random.uniform(0, 2) ? width * random.uniform(0.06, 0.16) : 0.0;
    const bool tongue = random.uniform(0, 2) != 0;
    cv::Mat map_x(portrait.size(), CV_32F), map_y(portrait.size(), CV_32F), moved;
    cv::Mat dark(portrait.size(), CV_32F, cv::Scalar(0)), bright = dark.clone(), red = dark.clone();
    for (int y = 0; y < portrait.rows; ++y)
        for (int x = 0; x < portrait.cols; ++x) {
            const Vec2 uv = frame.of(Vec2(x + 0.5, y + 0.5));
            const double top = mouth.top(uv.x), open = mouth.bottom(uv.x) - top;
            const double bottom = mouth.bottom(uv.x) + mouth.lip_drop(uv.x);
            Vec2 source = uv;
            if (mouth.inside(uv.x) && uv.y > top && uv.y < bottom) {
                const double seen = std::min(uv.y - top, 0.85 * open); // teeth that were in sight stay
                source.y = top + seen;
                dark.at<float>(y, x) = uv.y - top > std::max(0.8 * open, teeth) ? 1.0F : 0.0F;
                bright.at<float>(y, x) = open < 0.07 * width && uv.y - top < teeth ? 1.0F : 0.0F;
                red.at<float>(y, x) = tongue && bottom - uv.y < 0.4 * (bottom - top) ? 0.6F : 0.0F;
            } else if (uv.y >= bottom && (mouth.inside(uv.x) || uv.y > 0.0)) {
                source.y = mouth.before(uv.x, uv.y);
            }
            const Vec2 place = frame.back(source) - 0.5;
            map_x.at<float>(y, x) = static_cast<float>(place.x);
            map_y.at<float>(y, x) = static_cast<float>(place.y);
        }
    cv::remap(portrait, moved, map_x, map_y, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    moved.convertTo(moved, CV_32F);
    blend(moved, bright, {200.0, 210.0, 215.0}, width / 60.0);
    blend(moved, dark, {22.0, 22.0, 45.0}, width / 70.0);
    blend(moved, red.mul(dark), {70.0, 70.0, 130.0}, width / 40.0);
    cv::Mat result;
    moved.convertTo(result, CV_8U);
    return result;
}

} // namespace

Degraded with_opened_mouth(const cv::Mat& portrait, const std::vector<Contour>& truth, double openness,
                           unsigned seed) {
    const std::string how = "mouth opened " + std::to_string(std::lround(100.0 * openness)) + " %";
    const Contour* inner = contour_named(truth, feature::inner_lip);
    const Contour* right_eye = contour_named(truth, feature::right_eye);
    const Contour* left_eye = contour_named(truth, feature::left_eye);
    if (!inner || !right_eye || !left_eye)
        return {how, portrait, truth};
    const auto centre = [](const Contour& contour) { return bounds_of(flatten(contour).points).centre(); };
    const Vec2 eyes = centre(*left_eye) - centre(*right_eye);
    MouthFrame frame{centre(*inner), eyes / std::max(length(eyes), 1e-9)};
    const auto along = [&](Vec2 a, Vec2 b) { return frame.of(a).x < frame.of(b).x; };
    const std::vector<Vec2> lips = points_of(*inner);
    const auto [first, last] = std::minmax_element(lips.begin(), lips.end(), along);
    const double width = length(*last - *first);
    frame = {*first, (*last - *first) / std::max(width, 1e-9)};

    std::vector<Vec2> uv;
    std::array<std::vector<Vec2>, 2> parts; // upper, lower
    for (const Vec2 p : lips)
        uv.push_back(frame.of(p));
    const std::vector<bool> is_lower = on_lower_part(uv);
    for (std::size_t i = 0; i < uv.size(); ++i)
        parts[is_lower[i] ? 1 : 0].push_back(uv[i]);
    for (const Vec2 corner : {Vec2(0.0), Vec2(width, 0.0)})
        parts[1].push_back(corner);
    const OpenedLips mouth{Edge(parts[0]), Edge(parts[1]), width, openness * width};

    std::vector<Contour> moved;
    for (const Contour& contour : truth) {
        std::vector<Vec2> points;
        for (const Vec2 p : points_of(contour))
            points.push_back(frame.of(p));
        const bool is_lip = contour.name == feature::inner_lip || contour.name == feature::outer_lip;
        const std::vector<bool> lower = is_lip ? on_lower_part(points) : std::vector<bool>(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double v = points[i].y;
            const bool moves =
                is_lip ? lower[i]
                       : v >= mouth.bottom(points[i].x) && (mouth.inside(points[i].x) || v > 0.02 * width);
            if (moves)
                points[i].y += mouth.drop(points[i].x, std::max(v, mouth.bottom(points[i].x)));
            points[i] = frame.back(points[i]);
        }
        moved.push_back(contour_through(contour.name, points, contour.closed));
    }
    cv::RNG random(seed + 1);
    return {how, opened(portrait, frame, mouth, random), std::move(moved)};
}

} // namespace tp
