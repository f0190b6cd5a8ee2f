// SPDX-License-Identifier: Apache-2.0
#include "app/capture/seeing/frame_light.hpp"

#include <opencv2/core.hpp>

#include <cmath>

namespace tp {

namespace {

constexpr double middle = 0.7;    ///< of a box: without hair and background in its corners
constexpr double with_hair = 1.4; ///< boxes that no hair reaches beyond
constexpr double least_beside = 0.1;

/// The pixels of a box grown about its middle, as far as they are in the picture.
cv::Rect pixels_of(const cv::Mat& picture, const Rect& box, double grown) {
    const Vec2 size(picture.cols, picture.rows);
    const Vec2 half = 0.5 * grown * (box.max - box.min);
    const Vec2 low = glm::clamp(box.centre() - half, Vec2(0.0), Vec2(1.0)) * size;
    const Vec2 high = glm::clamp(box.centre() + half, Vec2(0.0), Vec2(1.0)) * size;
    return {cv::Point(static_cast<int>(low.x), static_cast<int>(low.y)),
            cv::Point(static_cast<int>(std::ceil(high.x)), static_cast<int>(std::ceil(high.y)))};
}

} // namespace

std::optional<double> brightness_of(const cv::Mat& grey, const Rect& face) {
    const cv::Rect place = pixels_of(grey, face, middle);
    if (place.empty())
        return std::nullopt;
    return cv::mean(grey(place))[0] / 255.0;
}

std::optional<double> brightness_beside(const cv::Mat& grey, const std::vector<Rect>& faces) {
    if (grey.empty())
        return std::nullopt;
    cv::Mat1b beside(grey.size(), 255);
    for (const Rect& face : faces)
        beside(pixels_of(grey, face, with_hair)) = 0;
    if (cv::countNonZero(beside) < least_beside * static_cast<double>(grey.total()))
        return std::nullopt;
    return cv::mean(grey, beside)[0] / 255.0;
}

} // namespace tp
