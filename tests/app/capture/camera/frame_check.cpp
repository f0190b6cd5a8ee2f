// SPDX-License-Identifier: Apache-2.0
#include "frame_check.hpp"

#include "app/capture/camera/camera_format.hpp"

#include <opencv2/core.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace tp::test {

namespace {

using Form = QVideoFrameFormat;

/// A frame out of bytes; each plane in memory of its own, so that a sanitizer sees whoever reads behind its end.
struct ToldFrame {
    MappedPicture picture;
    std::vector<std::vector<unsigned char>> memory;
};

ToldFrame told_frame(std::string_view bytes) {
    std::size_t at = 0;
    const auto byte = [&] { return at < bytes.size() ? static_cast<unsigned char>(bytes[at++]) : 0; };
    const auto number = [&] {
        const int low = byte();
        return low + 256 * byte();
    };
    ToldFrame frame;
    const int first = byte();
    frame.picture.form = told_forms[static_cast<std::size_t>(first % 64) % told_forms.size()];
    const int width = number();
    frame.picture.size = QSize(width, number());
    std::array<int, 3> steps{};
    for (std::size_t i = 0; i < 2; ++i)
        steps[i] = static_cast<std::int16_t>(number());
    steps[2] = steps[1];
    std::array<std::size_t, 3> lengths{};
    for (std::size_t i = 0; i < 2; ++i)
        lengths[i] = static_cast<std::size_t>(number());
    const std::size_t planes = static_cast<std::size_t>(first / 64);
    bytes.remove_prefix(at);
    for (std::size_t i = 0; i < planes; ++i) {
        const std::size_t length = i + 1 == planes ? bytes.size() : std::min(lengths[i], bytes.size());
        frame.memory.emplace_back(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
        bytes.remove_prefix(length);
    }
    for (std::size_t i = 0; i < planes; ++i)
        frame.picture.planes.push_back({frame.memory[i], steps[i]});
    return frame;
}

/// By the rule alone: whether each plane holds all that is told of it.
bool hold_the_picture(const MappedPicture& picture, const std::vector<PlaneNeeds>& needs) {
    if (picture.planes.size() < needs.size())
        return false;
    for (std::size_t i = 0; i < needs.size(); ++i) {
        const MappedPlane& plane = picture.planes[i];
        const long long end_of_last = plane.row_step * (needs[i].rows - 1) + needs[i].row_bytes;
        if (plane.row_step < needs[i].row_bytes || static_cast<long long>(plane.bytes.size()) < end_of_last)
            return false;
    }
    return true;
}

} // namespace

std::vector<PlaneNeeds> needs_of(Form::PixelFormat form, QSize size) {
    const int width = size.width(), height = size.height();
    switch (form) {
    case Form::Format_YUYV:
    case Form::Format_UYVY:
        return {{2 * width, height}};
    case Form::Format_Y8:
        return {{width, height}};
    case Form::Format_NV12:
    case Form::Format_NV21:
        return {{width, height}, {width, height / 2}};
    case Form::Format_YUV420P:
    case Form::Format_YV12:
        return {{width, height}, {width / 2, height / 2}, {width / 2, height / 2}};
    case Form::Format_Jpeg:
    case Form::Format_P010:
        return {};
    default:
        return {{4 * width, height}};
    }
}

std::string complaint_about_frame(std::string_view bytes) {
    const ToldFrame frame = told_frame(bytes);
    const cv::Mat pixels = bgr_of(frame.picture);
    if (pixels.empty())
        return {};
    const QSize told = frame.picture.size;
    if (!is_read(frame.picture.form))
        return "a picture of a form that is not read";
    const bool of_told_size = pixels.cols == told.width() && pixels.rows == told.height();
    if (pixels.type() != CV_8UC3 || (!of_told_size && frame.picture.form != Form::Format_Jpeg))
        return "a picture of another size than was told";
    if (pixels.total() > static_cast<std::size_t>(most_pixels))
        return "a picture that is larger than a camera's may be";
    return hold_the_picture(frame.picture, needs_of(frame.picture.form, told))
               ? ""
               : "a picture of more bytes than its planes hold";
}

} // namespace tp::test
