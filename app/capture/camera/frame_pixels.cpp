// SPDX-License-Identifier: Apache-2.0
#include "app/capture/camera/frame_pixels.hpp"

#include "app/capture/camera/mapped_picture.hpp"

#include <opencv2/core.hpp>

#include <cstddef>
#include <optional>

namespace tp {

namespace {

/// What of a mapped frame may be read, as Qt tells it.
MappedPicture mapped(const QVideoFrame& frame) {
    MappedPicture picture{frame.pixelFormat(), frame.size(), {}};
    for (int plane = 0; plane < frame.planeCount(); ++plane) {
        const int bytes = frame.mappedBytes(plane);
        const bool there = frame.bits(plane) != nullptr && bytes > 0;
        picture.planes.push_back(
            {{frame.bits(plane), there ? static_cast<std::size_t>(bytes) : 0}, frame.bytesPerLine(plane)});
    }
    return picture;
}

/// How many degrees the frame must be turned clockwise to be upright.
int degrees_of(const QVideoFrame& frame) {
#if QT_VERSION >= QT_VERSION_CHECK(6, 7, 0)
    return static_cast<int>(frame.rotation());
#else
    return static_cast<int>(frame.rotationAngle());
#endif
}

std::optional<cv::RotateFlags> turn_by(int degrees) {
    switch (degrees) {
    case 90:
        return cv::ROTATE_90_CLOCKWISE;
    case 180:
        return cv::ROTATE_180;
    case 270:
        return cv::ROTATE_90_COUNTERCLOCKWISE;
    default:
        return std::nullopt;
    }
}

} // namespace

cv::Mat upright_pixels(QVideoFrame frame) {
    // Before it is mapped: Qt divides by half a frame's height where that has planes.
    if (!can_be_read(frame.pixelFormat(), frame.size()) || !frame.map(QVideoFrame::ReadOnly))
        return {};
    cv::Mat pixels = bgr_of(mapped(frame));
    frame.unmap();
    if (pixels.empty())
        return {};
    if (frame.surfaceFormat().scanLineDirection() == QVideoFrameFormat::BottomToTop)
        cv::flip(pixels, pixels, 0);
    if (frame.mirrored())
        cv::flip(pixels, pixels, 1);
    if (const auto turn = turn_by(degrees_of(frame)))
        cv::rotate(pixels, pixels, *turn);
    return pixels;
}

} // namespace tp
