// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/closed_eyes.hpp"

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

constexpr double skin_above = 0.45, skin_below = 0.15; ///< what is stretched, of the eye's width
constexpr double lid_in_sight = 0.04;                  ///< more of it when the eye is shut, of the width

/// The rule by which the lids of an eye move.
class ClosedLids {
public:
    /// The lids meet `rise` of their gap above the lower one.
    ClosedLids(const OpenedShape& eye, double shut, double rise) : eye_(eye), shut_(shut), rise_(rise) {}

    const CornerFrame& frame() const { return eye_.frame; }
    double top_after(double u) const { return top(u) + shut_ * (meeting(u) - top(u)); }
    double bottom_after(double u) const { return bottom(u) - shut_ * (bottom(u) - meeting(u)); }
    /// Where what is seen at (u, v) after the move was before.
    double before(double u, double v) const {
        const double width = frame().width, highest = top(u) - skin_above * width,
                     lowest = bottom(u) + skin_below * width, upper = top_after(u), lower = bottom_after(u);
        if (!frame().inside(u) || v <= highest || v >= lowest)
            return v;
        if (v < upper) {
            const double along = (v - highest) / std::max(upper - highest, 1e-3);
            return highest + along * (skin_above - lid_in_sight * shut_) * width;
        }
        if (v <= lower)
            return std::max(v, top(u));
        return lowest - (lowest - v) / std::max(lowest - lower, 1e-3) * skin_below * width;
    }

private:
    double top(double u) const { return eye_.upper.at(u); }
    double bottom(double u) const { return std::max(eye_.lower.at(u), top(u)); }
    double meeting(double u) const { return bottom(u) - rise_ * (bottom(u) - top(u)); }

    OpenedShape eye_;
    double shut_, rise_;
};

/// `picture` (float BGR) with that eye closed.
void close_eye(cv::Mat& picture, const ClosedLids& lids, cv::RNG& random) {
    const CornerFrame& frame = lids.frame();
    const auto lash_share = static_cast<float>(random.uniform(0.3, 0.9));
    const double lash_half = std::max(0.7, 0.025 * frame.width);
    cv::Mat map_x(picture.size(), CV_32F), map_y(picture.size(), CV_32F), closed;
    cv::Mat lashes(picture.size(), CV_32F, cv::Scalar(0));
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x) {
            const Vec2 uv = frame.of(Vec2(x + 0.5, y + 0.5));
            if (frame.inside(uv.x) && std::abs(uv.y - lids.top_after(uv.x)) < lash_half)
                lashes.at<float>(y, x) = lash_share;
            const Vec2 place = frame.back({uv.x, lids.before(uv.x, uv.y)}) - 0.5;
            map_x.at<float>(y, x) = static_cast<float>(place.x);
            map_y.at<float>(y, x) = static_cast<float>(place.y);
        }
    cv::remap(picture, closed, map_x, map_y, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    const int reach = std::max(1, static_cast<int>(0.6 * frame.width));
    const Vec2 middle = frame.back({0.5 * frame.width, 0.0});
    const cv::Rect around = cv::Rect(static_cast<int>(middle.x) - reach, static_cast<int>(middle.y) - reach,
                                     2 * reach, 2 * reach) &
                            cv::Rect({0, 0}, picture.size());
    const cv::Scalar skin = around.empty() ? cv::Scalar() : cv::mean(closed(around));
    blend(closed, lashes, random.uniform(0.15, 0.5) * skin, frame.width / 60.0);
    picture = closed;
}

Contour closed_contour(const Contour& eye, const ClosedLids& lids) {
    std::vector<Vec2> points;
    for (const Vec2 p : many_points(eye))
        points.push_back(lids.frame().of(p));
    const std::vector<bool> lower = on_lower_edge(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (lids.frame().inside(points[i].x))
            points[i].y = lower[i] ? lids.bottom_after(points[i].x) : lids.top_after(points[i].x);
        points[i] = lids.frame().back(points[i]);
    }
    return contour_through(eye.name, points, eye.closed);
}

} // namespace

Degraded with_closed_eyes(const cv::Mat& portrait, const std::vector<Contour>& truth, double shut,
                          unsigned seed) {
    const std::string how = "eyes shut by " + std::to_string(std::lround(100.0 * shut)) + " %";
    const Contour* right_eye = contour_named(truth, feature::right_eye);
    const Contour* left_eye = contour_named(truth, feature::left_eye);
    if (!right_eye || !left_eye)
        return {how, portrait, truth};
    const Vec2 across = across_face(*right_eye, *left_eye);
    cv::RNG random(seed + 1);
    const double rise = random.uniform(0.0, 0.15);
    cv::Mat picture, result;
    portrait.convertTo(picture, CV_32F);
    std::vector<Contour> moved;
    for (const Contour& contour : truth) {
        if (contour.name != feature::right_eye && contour.name != feature::left_eye) {
            moved.push_back(contour);
            continue;
        }
        const ClosedLids lids(OpenedShape(contour, across), shut, rise);
        close_eye(picture, lids, random);
        moved.push_back(closed_contour(contour, lids));
    }
    picture.convertTo(result, CV_8U);
    return {how, std::move(result), std::move(moved)};
}

} // namespace tp
