// SPDX-License-Identifier: Apache-2.0
#include "app/capture/seeing/frame_sharpness.hpp"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

constexpr int longer_px = 1280; ///< of the frame, in which a neighbour is 1 px
constexpr int far_px = 8;
constexpr int least_side_px = 4 * far_px;
constexpr double least_contrast =
    2.0; ///< grey levels between places that are far apart: below it, only grain

/// Mean squared difference of places `apart` px from each other.
double difference(const cv::Mat& grey, int apart, bool down) {
    const cv::Mat one = down ? grey.rowRange(apart, grey.rows) : grey.colRange(apart, grey.cols);
    const cv::Mat other = down ? grey.rowRange(0, grey.rows - apart) : grey.colRange(0, grey.cols - apart);
    return cv::norm(one, other, cv::NORM_L2SQR) / static_cast<double>(one.total());
}

} // namespace

std::optional<double> fineness(const cv::Mat& pixels, const Rect& part) {
    if (pixels.empty() || !is_finite(part.min) || !is_finite(part.max))
        return std::nullopt;
    const Vec2 size(pixels.cols, pixels.rows);
    const Vec2 low = glm::clamp(part.min, Vec2(0.0), Vec2(1.0)) * size;
    const Vec2 high = glm::clamp(part.max, Vec2(0.0), Vec2(1.0)) * size;
    const cv::Rect place(cv::Point(static_cast<int>(low.x), static_cast<int>(low.y)),
                         cv::Point(static_cast<int>(high.x), static_cast<int>(high.y)));
    const int neighbour = std::max(
        1,
        static_cast<int>(std::lround(static_cast<double>(std::max(pixels.cols, pixels.rows)) / longer_px)));
    if (std::min(place.width, place.height) < least_side_px * neighbour)
        return std::nullopt;
    cv::Mat grey;
    cv::cvtColor(pixels(place), grey, cv::COLOR_BGR2GRAY);
    std::optional<double> least;
    for (const bool down : {false, true}) {
        const double far = difference(grey, far_px * neighbour, down);
        if (far < least_contrast * least_contrast)
            continue;
        const double fine = difference(grey, neighbour, down) / far;
        least = least ? std::min(*least, fine) : fine;
    }
    return least;
}

std::optional<double> FrameSharpness::see(std::optional<double> fine, double time_s) {
    const double dt = time_s - last_s_;
    last_s_ = time_s;
    if (!(dt >= 0.0))
        finest_ = 0.0;
    else
        finest_ *= std::exp2(-dt / halves_in_s);
    if (!fine)
        return std::nullopt;
    finest_ = std::max(finest_, *fine);
    return finest_ > 0.0 ? *fine / finest_ : 1.0;
}

} // namespace tp
