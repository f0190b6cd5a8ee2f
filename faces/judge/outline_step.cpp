// SPDX-License-Identifier: Apache-2.0
#include "faces/judge/outline_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tp {
namespace {

// Fractions of the distance between the eyes' outer corners.
constexpr double reach = 0.15;
constexpr int looks_each_way = 10;
constexpr double step_half = 0.02;  ///< colours that far before and behind a place are compared
constexpr double spot = 1.0 / 60.0; ///< side of the square over which a colour is averaged
constexpr std::size_t ends = 2;     ///< points left out at each end, which lies in the hair

cv::Vec3d colour_at(const cv::Mat& picture, Vec2 place, double side) {
    cv::Vec3d sum(0.0, 0.0, 0.0);
    const auto index = [](double at, int end) {
        return static_cast<int>(std::clamp(std::floor(at), 0.0, end - 1.0));
    };
    for (const double down : {-1.0, 0.0, 1.0})
        for (const double across : {-1.0, 0.0, 1.0})
            sum += picture.at<cv::Vec3b>(index(place.y + down * side / 3.0, picture.rows),
                                         index(place.x + across * side / 3.0, picture.cols));
    return sum / 9.0;
}

} // namespace

double outline_off_step(const cv::Mat& picture, const std::vector<Vec2>& outline, double unit_px) {
    if (picture.empty() || !(unit_px > 0.0))
        return 0.0;
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = ends; i + ends < outline.size(); ++i) {
        const Vec2 along = outline[i + 1] - outline[i - 1];
        if (!(length(along) > 0.0))
            continue;
        const Vec2 across = Vec2(along.y, -along.x) * (unit_px / length(along));
        double strongest = -1.0, place = 0.0;
        for (int look = -looks_each_way; look <= looks_each_way; ++look) {
            const double off = reach * look / looks_each_way;
            const double step =
                cv::norm(colour_at(picture, outline[i] + across * (off + step_half), spot * unit_px) -
                         colour_at(picture, outline[i] + across * (off - step_half), spot * unit_px));
            if (step > strongest) {
                strongest = step;
                place = std::abs(off);
            }
        }
        sum += place;
        ++count;
    }
    return count > 0 ? sum / count : 0.0;
}

} // namespace tp
