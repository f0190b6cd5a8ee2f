// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/camera/mapped_picture.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace tp::test {

/// By their number in the bytes of a told frame. The last one is not read.
inline constexpr std::array told_forms{QVideoFrameFormat::Format_BGRA8888, QVideoFrameFormat::Format_BGRX8888,
                                       QVideoFrameFormat::Format_RGBA8888, QVideoFrameFormat::Format_RGBX8888,
                                       QVideoFrameFormat::Format_YUYV,     QVideoFrameFormat::Format_UYVY,
                                       QVideoFrameFormat::Format_Y8,       QVideoFrameFormat::Format_NV12,
                                       QVideoFrameFormat::Format_NV21,     QVideoFrameFormat::Format_YUV420P,
                                       QVideoFrameFormat::Format_YV12,     QVideoFrameFormat::Format_Jpeg,
                                       QVideoFrameFormat::Format_P010};

/// How many bytes a row of such a plane has, and how many rows.
struct PlaneNeeds {
    int row_bytes = 0;
    int rows = 0;
};
/// What a picture of this form and size needs; nothing for what is coded or not read.
std::vector<PlaneNeeds> needs_of(QVideoFrameFormat::PixelFormat form, QSize size);

/// What does not hold where a camera gives these bytes, empty where all is well: one byte whose low six bits are the form and
/// whose high two the number of planes; width and height in two bytes each; how far the rows of two planes lie apart, signed,
/// in two bytes each (a third plane is as the second); the length of two planes in two bytes each; then the planes, the last
/// one to the end. Numbers have their low byte first.
std::string complaint_about_frame(std::string_view bytes);

} // namespace tp::test
