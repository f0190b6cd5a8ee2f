// SPDX-License-Identifier: Apache-2.0
#include "faces/detect/shrunk_rows.hpp"

#include "faces/base/block_means.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tp {
namespace {

constexpr int rows_at_once = 32; ///< of the result: these are held as floating-point numbers

struct RowShare {
    int row;
    float share;
};

/// Which rows make row `y` where every `scale` ≥ 1 of `height` rows become one.
std::vector<RowShare> shares_of(int y, double scale, int height) {
    constexpr double nothing = 1e-3; ///< what cv::resize leaves out, rows
    const double from = y * scale, to = from + scale, whole = std::min(scale, height - from);
    const int last = std::min(static_cast<int>(std::floor(to)), height - 1);
    const int first = std::min(static_cast<int>(std::ceil(from)), last);
    std::vector<RowShare> shares;
    if (first - from > nothing)
        shares.push_back({first - 1, static_cast<float>((first - from) / whole)});
    for (int row = first; row < last; ++row)
        shares.push_back({row, static_cast<float>(1.0 / whole)});
    if (to - last > nothing)
        shares.push_back({last, static_cast<float>(std::min(std::min(to - last, 1.0), whole) / whole)});
    return shares;
}

} // namespace

int block_factor(cv::Size picture, int longer) {
    return std::max(1, std::min(std::max(picture.width, picture.height) / longer,
                                std::min(picture.width, picture.height)));
}

cv::Mat shrunk_by_blocks(const cv::Mat& picture, int longer) {
    return block_means(picture, block_factor(picture.size(), longer));
}

cv::Size size_with_longer_side(cv::Size picture, int longer) {
    const double scale = static_cast<double>(longer) / std::max(picture.width, picture.height);
    const auto side = [&](int px) { return std::max(1, static_cast<int>(std::lround(px * scale))); };
    return {side(picture.width), side(picture.height)};
}

ShrunkRows::ShrunkRows(const cv::Mat& picture, int longer)
    : picture_(picture), factor_(block_factor(picture.size(), longer)),
      in_blocks_(picture.cols / factor_, picture.rows / factor_),
      size_(size_with_longer_side(in_blocks_, longer)) {}

cv::Mat ShrunkRows::rows(cv::Range wanted) const {
    const double scale =
        1.0 / (static_cast<double>(size_.height) / in_blocks_.height); // as cv::resize has it
    cv::Mat result(wanted.size(), size_.width, CV_8UC3), above, narrow;
    std::vector<float> sum(3 * static_cast<std::size_t>(size_.width));
    for (int begin = wanted.start; begin < wanted.end; begin += rows_at_once) {
        const int end = std::min(begin + rows_at_once, wanted.end);
        const int first = shares_of(begin, scale, in_blocks_.height).front().row;
        const int last = shares_of(end - 1, scale, in_blocks_.height).back().row;
        const cv::Mat band = block_means(picture_.rowRange(first * factor_, (last + 1) * factor_), factor_);
        band.convertTo(above, CV_32F);
        cv::resize(above, narrow, {size_.width, above.rows}, 0, 0, cv::INTER_AREA);
        for (int y = begin; y < end; ++y) {
            std::fill(sum.begin(), sum.end(), 0.0F);
            for (const RowShare& part : shares_of(y, scale, in_blocks_.height)) {
                const float* row = narrow.ptr<float>(part.row - first);
                for (std::size_t i = 0; i < sum.size(); ++i)
                    sum[i] += part.share * row[i]; // cv::scaleAdd rounds otherwise where it fuses these
            }
            std::transform(sum.begin(), sum.end(), result.ptr<uchar>(y - wanted.start),
                           [](float value) { return cv::saturate_cast<uchar>(value); });
        }
    }
    return result;
}

} // namespace tp
