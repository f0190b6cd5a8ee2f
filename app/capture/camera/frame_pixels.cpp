// SPDX-License-Identifier: Apache-2.0
#include "app/capture/camera/frame_pixels.hpp"

#include <QByteArray>
#include <QImage>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <optional>

namespace tp {

namespace {

using Form = QVideoFrameFormat;

/// Of one plane without gaps between its rows, how OpenCV makes BGR of it.
struct PlaneForm {
    Form::PixelFormat form;
    int type;
    int to_bgr;
};
constexpr std::array plane_forms{
    PlaneForm{Form::Format_BGRA8888, CV_8UC4, cv::COLOR_BGRA2BGR},
    PlaneForm{Form::Format_BGRX8888, CV_8UC4, cv::COLOR_BGRA2BGR},
    PlaneForm{Form::Format_RGBA8888, CV_8UC4, cv::COLOR_RGBA2BGR},
    PlaneForm{Form::Format_RGBX8888, CV_8UC4, cv::COLOR_RGBA2BGR},
    PlaneForm{Form::Format_YUYV, CV_8UC2, cv::COLOR_YUV2BGR_YUYV},
    PlaneForm{Form::Format_UYVY, CV_8UC2, cv::COLOR_YUV2BGR_UYVY},
    PlaneForm{Form::Format_Y8, CV_8UC1, cv::COLOR_GRAY2BGR},
};

/// Of a plane of brightness and, in half the size, one or two of colour.
struct YuvForm {
    Form::PixelFormat form;
    int planes;
    int to_bgr;
};
constexpr std::array yuv_forms{
    YuvForm{Form::Format_NV12, 2, cv::COLOR_YUV2BGR_NV12},
    YuvForm{Form::Format_NV21, 2, cv::COLOR_YUV2BGR_NV21},
    YuvForm{Form::Format_YUV420P, 3, cv::COLOR_YUV2BGR_I420},
    YuvForm{Form::Format_YV12, 3, cv::COLOR_YUV2BGR_YV12},
};

template <typename List>
auto found_in(const List& list, Form::PixelFormat form) {
    return std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.form == form; });
}

/// `rows` of `row_bytes` each, out of a plane whose rows may lie further apart; false where the plane is too short.
bool copy_rows(const QVideoFrame& frame, int plane, int rows, int row_bytes, uchar* to) {
    const int apart = frame.bytesPerLine(plane);
    const uchar* from = frame.bits(plane);
    if (from == nullptr || apart < row_bytes ||
        static_cast<long long>(apart) * (rows - 1) + row_bytes > frame.mappedBytes(plane))
        return false;
    for (int y = 0; y < rows; ++y)
        std::memcpy(to + static_cast<std::ptrdiff_t>(y) * row_bytes,
                    from + static_cast<std::ptrdiff_t>(y) * apart, static_cast<std::size_t>(row_bytes));
    return true;
}

cv::Mat bgr_of_plane(const QVideoFrame& frame, const PlaneForm& form) {
    cv::Mat pixels(frame.height(), frame.width(), form.type), bgr;
    const int row_bytes = frame.width() * static_cast<int>(pixels.elemSize());
    if (!copy_rows(frame, 0, frame.height(), row_bytes, pixels.data))
        return {};
    cv::cvtColor(pixels, bgr, form.to_bgr);
    return bgr;
}

cv::Mat bgr_of_yuv(const QVideoFrame& frame, const YuvForm& form) {
    const int width = frame.width(), height = frame.height();
    if (width % 2 != 0 || height % 2 != 0 || frame.planeCount() != form.planes)
        return {};
    cv::Mat pixels(height * 3 / 2, width, CV_8UC1), bgr;
    uchar* to = pixels.data;
    if (!copy_rows(frame, 0, height, width, to))
        return {};
    to += static_cast<std::ptrdiff_t>(width) * height;
    const int colour_row = form.planes == 2 ? width : width / 2;
    for (int plane = 1; plane < form.planes; ++plane) {
        if (!copy_rows(frame, plane, height / 2, colour_row, to))
            return {};
        to += static_cast<std::ptrdiff_t>(colour_row) * (height / 2);
    }
    cv::cvtColor(pixels, bgr, form.to_bgr);
    return bgr;
}

cv::Mat bgr_of_jpeg(const QVideoFrame& frame) {
    const auto* bytes = reinterpret_cast<const char*>(frame.bits(0));
    QImage picture;
    picture.loadFromData(QByteArray::fromRawData(bytes, frame.mappedBytes(0)), "JPG");
    if (picture.isNull())
        return {};
    picture = picture.convertToFormat(QImage::Format_BGR888);
    return cv::Mat(picture.height(), picture.width(), CV_8UC3, picture.bits(),
                   static_cast<std::size_t>(picture.bytesPerLine()))
        .clone();
}

cv::Mat bgr_of(const QVideoFrame& frame) {
    const Form::PixelFormat form = frame.pixelFormat();
    if (const auto plane = found_in(plane_forms, form); plane != plane_forms.end())
        return bgr_of_plane(frame, *plane);
    if (const auto yuv = found_in(yuv_forms, form); yuv != yuv_forms.end())
        return bgr_of_yuv(frame, *yuv);
    return form == Form::Format_Jpeg ? bgr_of_jpeg(frame) : cv::Mat();
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

bool is_read(Form::PixelFormat form) {
    return form == Form::Format_Jpeg || found_in(plane_forms, form) != plane_forms.end() ||
           found_in(yuv_forms, form) != yuv_forms.end();
}

cv::Mat upright_pixels(QVideoFrame frame) {
    if (!is_read(frame.pixelFormat()) || frame.width() <= 0 || frame.height() <= 0 ||
        !frame.map(QVideoFrame::ReadOnly))
        return {};
    cv::Mat pixels = bgr_of(frame);
    frame.unmap();
    if (pixels.empty())
        return {};
    if (frame.surfaceFormat().scanLineDirection() == Form::BottomToTop)
        cv::flip(pixels, pixels, 0);
    if (frame.mirrored())
        cv::flip(pixels, pixels, 1);
    if (const auto turn = turn_by(degrees_of(frame)))
        cv::rotate(pixels, pixels, *turn);
    return pixels;
}

} // namespace tp
