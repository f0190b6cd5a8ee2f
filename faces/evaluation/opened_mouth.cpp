// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/opened_mouth.hpp"

#include "faces/evaluation/contour_error.hpp"
#include "faces/evaluation/corner_frame.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace tp {
namespace {

/// The rule by which lower lip, jaw and neck move.
class OpenedLips {
public:
    OpenedLips(const OpenedShape& lips, double openness)
        : lips_(lips), width_(lips.frame.width), drop_(openness * lips.frame.width) {}

    const CornerFrame& frame() const { return lips_.frame; }
    double top(double u) const { return lips_.upper.at(u); }
    /// Of the lower lip's inner edge, before it moves.
    double bottom(double u) const { return std::max(lips_.lower.at(u), top(u)); }
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

private:
    OpenedShape lips_;
    double width_, drop_;
};

cv::Mat opened(const cv::Mat& portrait, const OpenedLips& mouth, cv::RNG& random) {
    const CornerFrame& frame = mouth.frame();
    const double width = frame.width;
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
            if (frame.inside(uv.x) && uv.y > top && uv.y < bottom) {
                const double seen = std::min(uv.y - top, 0.85 * open); // teeth that were in sight stay
                source.y = top + seen;
                dark.at<float>(y, x) = uv.y - top > std::max(0.8 * open, teeth) ? 1.0F : 0.0F;
                bright.at<float>(y, x) = open < 0.07 * width && uv.y - top < teeth ? 1.0F : 0.0F;
                red.at<float>(y, x) = tongue && bottom - uv.y < 0.4 * (bottom - top) ? 0.6F : 0.0F;
            } else if (uv.y >= bottom && (frame.inside(uv.x) || uv.y > 0.0)) {
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
    const OpenedLips mouth(OpenedShape(*inner, across_face(*right_eye, *left_eye)), openness);
    const CornerFrame& frame = mouth.frame();
    std::vector<Contour> moved;
    for (const Contour& contour : truth) {
        std::vector<Vec2> points;
        for (const Vec2 p : many_points(contour))
            points.push_back(frame.of(p));
        const bool is_lip = contour.name == feature::inner_lip || contour.name == feature::outer_lip;
        const std::vector<bool> lower = is_lip ? on_lower_edge(points) : std::vector<bool>(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double v = points[i].y;
            const bool moves = is_lip ? lower[i]
                                      : v >= mouth.bottom(points[i].x) &&
                                            (frame.inside(points[i].x) || v > 0.02 * frame.width);
            if (moves)
                points[i].y += mouth.drop(points[i].x, std::max(v, mouth.bottom(points[i].x)));
            points[i] = frame.back(points[i]);
        }
        moved.push_back(contour_through(contour.name, points, contour.closed));
    }
    cv::RNG random(seed + 1);
    return {how, opened(portrait, mouth, random), std::move(moved)};
}

} // namespace tp
