// SPDX-License-Identifier: Apache-2.0
#include "app/capture/camera/mapped_picture.hpp"

#include "app/capture/camera/camera_format.hpp"
#include "faces/decode/jpeg_picture.hpp"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace tp {

namespace {

using Form = QVideoFrameFormat;

/// Of one plane without gaps between its rows, how OpenCV makes BGR of it.
struct PlaneForm {
    Form::PixelFormat form;
    int type;
    int to_bgr;
    bool in_pairs = false; ///< two pixels of a row share their colour
};
constexpr std::array plane_forms{
    PlaneForm{Form::Format_BGRA8888, CV_8UC4, cv::COLOR_BGRA2BGR},
    PlaneForm{Form::Format_BGRX8888, CV_8UC4, cv::COLOR_BGRA2BGR},
    PlaneForm{Form::Format_RGBA8888, CV_8UC4, cv::COLOR_RGBA2BGR},
    PlaneForm{Form::Format_RGBX8888, CV_8UC4, cv::COLOR_RGBA2BGR},
    PlaneForm{Form::Format_YUYV, CV_8UC2, cv::COLOR_YUV2BGR_YUYV, true},
    PlaneForm{Form::Format_UYVY, CV_8UC2, cv::COLOR_YUV2BGR_UYVY, true},
    PlaneForm{Form::Format_Y8, CV_8UC1, cv::COLOR_GRAY2BGR},
};

/// Of a plane of brightness and, in half the size, one or two of colour.
struct YuvForm {
    Form::PixelFormat form;
    std::size_t planes;
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
bool copy_rows(const MappedPlane& plane, int rows, int row_bytes, unsigned char* to) {
    if (plane.row_step < row_bytes || plane.row_step > static_cast<long long>(plane.bytes.size()) ||
        plane.row_step * (rows - 1) + row_bytes > static_cast<long long>(plane.bytes.size()))
        return false;
    const unsigned char* from = plane.bytes.data();
    for (int y = 0; y < rows; ++y, from += plane.row_step, to += row_bytes)
        std::memcpy(to, from, static_cast<std::size_t>(row_bytes));
    return true;
}

cv::Mat bgr_of_plane(const MappedPicture& picture, const PlaneForm& form) {
    cv::Mat pixels(picture.size.height(), picture.size.width(), form.type), bgr;
    const int row_bytes = pixels.cols * static_cast<int>(pixels.elemSize());
    if (picture.planes.empty() || !copy_rows(picture.planes[0], pixels.rows, row_bytes, pixels.data))
        return {};
    cv::cvtColor(pixels, bgr, form.to_bgr);
    return bgr;
}

cv::Mat bgr_of_yuv(const MappedPicture& picture, const YuvForm& form) {
    const int width = picture.size.width(), height = picture.size.height();
    if (picture.planes.size() != form.planes)
        return {};
    cv::Mat pixels(height * 3 / 2, width, CV_8UC1), bgr;
    unsigned char* to = pixels.data;
    if (!copy_rows(picture.planes[0], height, width, to))
        return {};
    to += static_cast<std::ptrdiff_t>(width) * height;
    const int colour_row = form.planes == 2 ? width : width / 2;
    for (std::size_t plane = 1; plane < form.planes; ++plane) {
        if (!copy_rows(picture.planes[plane], height / 2, colour_row, to))
            return {};
        to += static_cast<std::ptrdiff_t>(colour_row) * (height / 2);
    }
    cv::cvtColor(pixels, bgr, form.to_bgr);
    return bgr;
}

cv::Mat bgr_of_jpeg(const MappedPicture& picture) {
    if (picture.planes.empty())
        return {};
    const Bytes bytes(picture.planes[0].bytes.begin(), picture.planes[0].bytes.end());
    const JpegHeader header = jpeg_header(bytes);
    if (!can_be_read(picture.form, {header.width, header.height}))
        return {};
    const Result<cv::Mat> pixels = decode_jpeg(bytes, header, 1, JpegDamage::shown);
    return pixels ? *pixels : cv::Mat();
}

} // namespace

bool is_read(Form::PixelFormat form) {
    return form == Form::Format_Jpeg || found_in(plane_forms, form) != plane_forms.end() ||
           found_in(yuv_forms, form) != yuv_forms.end();
}

bool can_be_read(Form::PixelFormat form, QSize size) {
    if (!is_read(form) || size.isEmpty() ||
        static_cast<long long>(size.width()) * size.height() > most_pixels)
        return false;
    const auto plane = found_in(plane_forms, form);
    const bool in_squares = found_in(yuv_forms, form) != yuv_forms.end();
    const bool in_pairs = in_squares || (plane != plane_forms.end() && plane->in_pairs);
    return !(in_pairs && size.width() % 2 != 0) && !(in_squares && size.height() % 2 != 0);
}

cv::Mat bgr_of(const MappedPicture& picture) {
    if (!can_be_read(picture.form, picture.size))
        return {};
    if (const auto plane = found_in(plane_forms, picture.form); plane != plane_forms.end())
        return bgr_of_plane(picture, *plane);
    if (const auto yuv = found_in(yuv_forms, picture.form); yuv != yuv_forms.end())
        return bgr_of_yuv(picture, *yuv);
    return bgr_of_jpeg(picture);
}

} // namespace tp
