// SPDX-License-Identifier: Apache-2.0
#include "faces/contours/crop.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double shrink_from = 1.5; ///< picture px per crop px, above which areas are averaged first

Affine map_of(const CropFrame& frame, int size) {
    const double scale = frame.side / size;
    const double c = std::cos(frame.angle) * scale, s = std::sin(frame.angle) * scale;
    const double x = frame.mirrored ? -1.0 : 1.0;
    Affine map;
    map.linear = glm::dmat2(c * x, s * x, -s, c); // by columns
    map.offset = frame.centre - map.linear * Vec2(0.5 * size);
    return map;
}

/// The part of the picture that the window touches, with a margin for interpolation.
cv::Rect window_of(const CropFrame& frame, const cv::Size& picture) {
    const double reach =
        0.5 * frame.side * (std::abs(std::cos(frame.angle)) + std::abs(std::sin(frame.angle))) +
        2.0 * shrink_from + 0.02 * frame.side;
    const auto clipped = [](double at, int end) {
        return static_cast<int>(std::clamp(at, 0.0, double(end)));
    };
    const int left = std::min(clipped(std::floor(frame.centre.x - reach), picture.width), picture.width - 1);
    const int top = std::min(clipped(std::floor(frame.centre.y - reach), picture.height), picture.height - 1);
    const int right = std::max(clipped(std::ceil(frame.centre.x + reach), picture.width), left + 1);
    const int bottom = std::max(clipped(std::ceil(frame.centre.y + reach), picture.height), top + 1);
    return {left, top, right - left, bottom - top};
}

} // namespace

bool is_sane(const CropFrame& frame, const cv::Mat& picture) {
    if (!is_finite(frame.centre) || !std::isfinite(frame.side) || !std::isfinite(frame.angle))
        return false;
    const Rect around{Vec2(-frame.side), Vec2(picture.cols, picture.rows) + frame.side};
    return frame.side >= 1.0 && frame.side <= 8.0 * std::max(picture.cols, picture.rows) &&
           around.contains(frame.centre);
}

Crop take_crop(const cv::Mat& picture, const CropFrame& frame, int size) {
    const Affine to_picture = map_of(frame, size);
    const double scale = frame.side / size;
    cv::Mat source = picture;
    Vec2 origin(0.0), zoom(1.0); // source px = (picture px - origin) * zoom
    if (scale > shrink_from) {
        const cv::Rect window = window_of(frame, picture.size());
        const auto shrunk = [&](int side) {
            return std::max(1, static_cast<int>(std::lround(side / scale)));
        };
        cv::resize(picture(window), source, cv::Size(shrunk(window.width), shrunk(window.height)), 0, 0,
                   cv::INTER_AREA);
        origin = Vec2(window.x, window.y);
        zoom = Vec2(source.cols, source.rows) / Vec2(window.width, window.height);
    }
    // OpenCV counts from the middle of pixel (0, 0), we from its corner.
    const auto to_source = [&](Vec2 crop_px) { return (to_picture(crop_px + 0.5) - origin) * zoom - 0.5; };
    const Vec2 at = to_source(Vec2(0.0)), x = to_source(Vec2(1.0, 0.0)) - at,
               y = to_source(Vec2(0.0, 1.0)) - at;
    const cv::Matx23d matrix(x.x, y.x, at.x, x.y, y.y, at.y);
    Crop crop;
    crop.to_picture = to_picture;
    cv::warpAffine(source, crop.pixels, matrix, cv::Size(size, size), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                   cv::BORDER_REPLICATE);
    return crop;
}

} // namespace tp
