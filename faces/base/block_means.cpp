// SPDX-License-Identifier: Apache-2.0
#include "faces/base/block_means.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tp {
namespace {

constexpr int channels = 3;
constexpr int most_rows = 257; ///< whose sum of 255 each fits into 16 bits

/// Sums of `count` rows from `first` on, value by value: a loop that compilers make eight or more steps wide.
void add_rows(const cv::Mat& picture, int first, int count, std::vector<std::uint16_t>& sum) {
    std::fill(sum.begin(), sum.end(), std::uint16_t{0});
    const std::size_t values = sum.size();
    std::uint16_t* out = sum.data();
    for (int row = first; row < first + count; ++row) {
        const uchar* in = picture.ptr<uchar>(row);
        for (std::size_t i = 0; i < values; ++i)
            out[i] = static_cast<std::uint16_t>(out[i] + in[i]);
    }
}

} // namespace

cv::Mat block_means(const cv::Mat& picture, int factor) {
    if (factor < 2)
        return picture;
    const cv::Size size(picture.cols / factor, picture.rows / factor);
    cv::Mat result(size, CV_8UC3);
    if (factor == 2 || factor > most_rows) { // by 2 OpenCV is as fast
        cv::resize(picture(cv::Rect(0, 0, size.width * factor, size.height * factor)), result, size, 0, 0,
                   cv::INTER_AREA);
        return result;
    }
    const float share = 1.0F / static_cast<float>(factor * factor);
    std::vector<std::uint16_t> sum(static_cast<std::size_t>(size.width * factor * channels));
    for (int y = 0; y < size.height; ++y) {
        add_rows(picture, y * factor, factor, sum);
        const std::uint16_t* in = sum.data();
        uchar* out = result.ptr<uchar>(y);
        for (int x = 0; x < size.width; ++x, out += channels) {
            std::uint32_t blue = 0, green = 0, red = 0;
            for (int i = 0; i < factor; ++i, in += channels) {
                blue += in[0];
                green += in[1];
                red += in[2];
            }
            out[0] = static_cast<uchar>(cvRound(share * static_cast<float>(blue)));
            out[1] = static_cast<uchar>(cvRound(share * static_cast<float>(green)));
            out[2] = static_cast<uchar>(cvRound(share * static_cast<float>(red)));
        }
    }
    return result;
}

} // namespace tp
