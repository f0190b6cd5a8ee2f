// SPDX-License-Identifier: Apache-2.0
#include "faces/contours/shrunk.hpp"

#include "faces/base/block_means.hpp"

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double reach = 1.5; ///< from the face's centre, of its size: windows with room to turn

/// [low, high) within [0, end), `high - low` a multiple of `step`.
std::pair<int, int> span(double low, double high, int end, int step) {
    const int from = static_cast<int>(std::clamp(std::floor(low), 0.0, double(end)));
    const int to = static_cast<int>(std::clamp(std::ceil(high), double(from), double(end)));
    return {from, from + (to - from) / step * step};
}

} // namespace

Shrunk shrunk_around(const cv::Mat& picture, const Detection& face, double large_enough_px) {
    const double most = std::min(picture.cols, picture.rows) / 2.0;
    const double wanted = std::clamp(std::floor(face.size() / large_enough_px), 1.0, std::max(1.0, most));
    const int by = static_cast<int>(std::isfinite(wanted) ? wanted : 1.0);
    Shrunk result{picture, face, {}};
    if (by < 2)
        return result;
    const Vec2 centre = face.box.centre();
    const double away = reach * face.size();
    if (!std::isfinite(centre.x + centre.y + away))
        return result;
    const auto [left, right] = span(centre.x - away, centre.x + away, picture.cols, by);
    const auto [top, bottom] = span(centre.y - away, centre.y + away, picture.rows, by);
    if (right <= left || bottom <= top)
        return result;
    const cv::Rect window(left, top, right - left, bottom - top);
    result.pixels = block_means(picture(window), by);
    result.to_picture.linear = glm::dmat2(by);
    result.to_picture.offset = Vec2(left, top);
    const auto moved = [&](Vec2 p) { return (p - result.to_picture.offset) / double(by); };
    result.face.box = {moved(face.box.min), moved(face.box.max)};
    result.face.right_eye = moved(face.right_eye);
    result.face.left_eye = moved(face.left_eye);
    return result;
}

} // namespace tp
