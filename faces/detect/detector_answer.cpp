// SPDX-License-Identifier: Apache-2.0
#include "faces/detect/detector_answer.hpp"

#include "faces/models/model_catalog.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace tp {
namespace {

constexpr int block = 32; ///< px; the sides that the net is shown must be multiples of this
/// An answer rests on what lies within 175 px before and 143 px behind its block (the layers in
/// training/nets.py, Detector); whole blocks, so that a part's blocks are the picture's.
constexpr int margin = 192;
constexpr int grey = 127; ///< of the border

/// Some px of a side, and the px that the net is shown for them.
struct Part {
    cv::Range inner, shown;
};

/// `side` is a multiple of `block`.
std::vector<Part> parts_of(int side, int longest) {
    const int count = (side + longest - 1) / longest;
    const int blocks = side / block;
    std::vector<Part> parts;
    for (int i = 0; i < count; ++i) {
        const cv::Range inner(i * blocks / count * block, (i + 1) * blocks / count * block);
        parts.push_back({inner, {std::max(inner.start - margin, 0), std::min(inner.end + margin, side)}});
    }
    return parts;
}

cv::Mat plane(const cv::Mat& blob, int channel) {
    return {blob.size[2], blob.size[3], CV_32F, const_cast<float*>(blob.ptr<float>(0, channel))};
}

int in_blocks(int side) { return (side + block - 1) / block * block; }

/// Those pixels as the net was trained to see them; grey where there is no picture. (cv::dnn::blobFromImage
/// makes a floating-point copy of the picture beside the blob.)
cv::Mat blob_of(const cv::Mat& picture, cv::Range rows, cv::Range columns) {
    std::array<float, 256> inputs{};
    for (std::size_t value = 0; value < inputs.size(); ++value)
        inputs[value] = (static_cast<float>(value) - 127.5F) * static_cast<float>(1.0 / 255.0);
    cv::Mat blob({1, 3, rows.size(), columns.size()}, CV_32F, cv::Scalar::all(inputs[grey]));
    const int end = std::min(columns.end, picture.cols);
    for (int y = rows.start; y < std::min(rows.end, picture.rows); ++y)
        for (int channel = 0; channel < 3; ++channel) {
            const uchar* from = picture.ptr(y) + channel;
            float* to = plane(blob, channel).ptr<float>(y - rows.start);
            for (int x = columns.start; x < end; ++x)
                *to++ = inputs[from[3 * x]];
        }
    return blob;
}

cv::Mat answer_about(cv::dnn::Net& net, const cv::Mat& picture, cv::Range rows, cv::Range columns) {
    net.setInput(blob_of(picture, rows, columns)); // which copies it
    return net.forward();
}

} // namespace

cv::Mat detector_answer(cv::dnn::Net& net, const cv::Mat& picture) {
    return answer_about(net, picture, {0, in_blocks(picture.rows)}, {0, in_blocks(picture.cols)});
}

cv::Mat detector_answer_in_parts(const cv::Mat& picture, int longest_part) {
    const int height = in_blocks(picture.rows), width = in_blocks(picture.cols);
    cv::Mat whole;
    for (const Part& down : parts_of(height, longest_part))
        for (const Part& across : parts_of(width, longest_part)) {
            cv::dnn::Net net = embedded_net(EmbeddedModel::detector);
            const cv::Mat part = answer_about(net, picture, down.shown, across.shown);
            if (whole.empty())
                whole.create({1, part.size[1], height / detector_cell, width / detector_cell}, CV_32F);
            const auto cells = [](cv::Range px, int from) {
                return cv::Range((px.start - from) / detector_cell, (px.end - from) / detector_cell);
            };
            for (int channel = 0; channel < part.size[1]; ++channel)
                plane(part, channel)(cells(down.inner, down.shown.start),
                                     cells(across.inner, across.shown.start))
                    .copyTo(plane(whole, channel)(cells(down.inner, 0), cells(across.inner, 0)));
        }
    return whole;
}

} // namespace tp
