// SPDX-License-Identifier: Apache-2.0
#include "faces/identity/sharpened.hpp"

#include "faces/identity/unfit.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace tp {
namespace {

// By sharpness(): portraits as they are 0.22 and more, faces of 40 px 0.10 to 0.17, those blurred by 3 % of the eyes'
// distance 0.07 to 0.11, by 5 % 0.04 to 0.065.
constexpr double sharp_from = 0.12, soft_up_to = 0.06;
constexpr double mask_px = 2.5; ///< the mask's blur
constexpr double most = 2.0;    ///< times the difference to the mask is added to a soft face

} // namespace

cv::Mat sharpened_where_soft(const cv::Mat& square) {
    const double amount =
        most * std::clamp((sharp_from - sharpness(square)) / (sharp_from - soft_up_to), 0.0, 1.0);
    if (!(amount > 0.0))
        return square;
    cv::Mat mask, result;
    cv::GaussianBlur(square, mask, {}, mask_px);
    cv::addWeighted(square, 1.0 + amount, mask, -amount, 0.0, result);
    return result;
}

} // namespace tp
