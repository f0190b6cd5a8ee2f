// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/fitted.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tp {
namespace {

/// How much of its size a picture keeps when it has to fit into `box`; 1 at most.
double share_to_fit(cv::Size size, cv::Size box) {
    return std::min(
        {1.0, box.width / static_cast<double>(size.width), box.height / static_cast<double>(size.height)});
}

} // namespace

cv::Size no_box() { return {std::numeric_limits<int>::max(), std::numeric_limits<int>::max()}; }

cv::Size fitted(cv::Size size, cv::Size box) {
    const double share = share_to_fit(size, box);
    const auto side = [&](int px) { return std::max(1, static_cast<int>(std::lround(px * share))); };
    return share < 1.0 ? cv::Size(side(size.width), side(size.height)) : size;
}

cv::Mat resized(const cv::Mat& picture, cv::Size size) {
    if (picture.size() == size)
        return picture;
    cv::Mat small;
    cv::resize(picture, small, size, 0, 0, cv::INTER_AREA);
    return small;
}

int shrink_to_fill(cv::Size size, cv::Size box) {
    const double share = share_to_fit(size, box);
    for (const int shrink : {8, 4, 2})
        if (share * shrink <= 1.0)
            return shrink;
    return 1;
}

} // namespace tp
