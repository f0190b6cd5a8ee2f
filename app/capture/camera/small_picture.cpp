// SPDX-License-Identifier: Apache-2.0
#include "app/capture/camera/small_picture.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tp {

QImage small_picture(const cv::Mat& pixels, int longest_px) {
    if (pixels.empty() || pixels.type() != CV_8UC3)
        return {};
    const double scale = std::min(1.0, static_cast<double>(longest_px) / std::max(pixels.cols, pixels.rows));
    const auto scaled = [scale](int length) {
        return std::max(1, static_cast<int>(std::lround(scale * length)));
    };
    QImage picture(scaled(pixels.cols), scaled(pixels.rows), QImage::Format_BGR888);
    cv::Mat into(picture.height(), picture.width(), CV_8UC3, picture.bits(),
                 static_cast<std::size_t>(picture.bytesPerLine()));
    cv::resize(pixels, into, into.size(), 0.0, 0.0, cv::INTER_AREA);
    return picture;
}

} // namespace tp
