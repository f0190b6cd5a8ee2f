// SPDX-License-Identifier: Apache-2.0
#include "faces/identity/unfit.hpp"

#include "core/geometry/flatten.hpp"
#include "core/geometry/polyline.hpp"
#include "faces/identity/face_square.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <vector>

namespace tp {
namespace {

constexpr double most_outside = 0.03; ///< of the face's width, that its contours may leave the picture
/// Between the eyes, of the way from there to the mouth: 0.86 and more from the front, 0.71 and more turned by 34° (98
/// of 100 each), 0.7 with the mouth wide open, 0.6 near profile.
constexpr double in_profile_below = 0.65;
/// Blurred by 5 % of the eyes' distance 0.065 and less (99 of 100), faces of 36 px 0.074 and more.
constexpr double blurred_below = 0.066;
constexpr double blur_px = 1.5; ///< of sharpness()

bool is_cut_off(const cv::Size& picture, const Face& face) {
    std::vector<Vec2> all;
    for (const Contour& contour : face.contours) {
        const std::vector<Vec2> points = flatten(contour).points;
        all.insert(all.end(), points.begin(), points.end());
    }
    const Rect seen = bounds_of(all);
    const double most = most_outside * face.box.width();
    return seen.min.x < -most || seen.min.y < -most || seen.max.x > picture.width + most ||
           seen.max.y > picture.height + most;
}

bool is_covered(const Face& face) {
    for (std::size_t i = 0; i < std::min(face.contours.size(), face.quality.size()); ++i) {
        const std::string& name = face.contours[i].name;
        const bool mended = std::ranges::count(face.mended, name) > 0;
        if (name != feature::outline && !mended && is_said_hidden(face.quality[i]))
            return true;
    }
    return false;
}

double steps_in(const cv::Mat& grey) {
    cv::Mat across, down;
    cv::Sobel(grey, across, CV_32F, 1, 0, 1);
    cv::Sobel(grey, down, CV_32F, 0, 1, 1);
    return cv::norm(across, cv::NORM_L1) + cv::norm(down, cv::NORM_L1);
}

} // namespace

double sharpness(const cv::Mat& square) {
    cv::Mat grey, soft;
    cv::cvtColor(square, grey, cv::COLOR_BGR2GRAY);
    grey.convertTo(grey, CV_32F);
    cv::GaussianBlur(grey, soft, {}, blur_px);
    const double steps = steps_in(grey);
    return steps > 0.0 ? 1.0 - steps_in(soft) / steps : 0.0;
}

Unfit unfit_for_guessing(const cv::Mat& picture, const Face& face) {
    const auto places = face_places(face);
    if (!places)
        return Unfit::no_contours;
    const Vec2 between = 0.5 * (places->left_eye + places->right_eye);
    const double eyes = length(places->left_eye - places->right_eye), down = length(places->mouth - between);
    if (eyes < smallest_eyes_px)
        return Unfit::too_small;
    if (is_cut_off(picture.size(), face))
        return Unfit::cut_off;
    if (eyes < in_profile_below * down)
        return Unfit::in_profile;
    if (is_covered(face))
        return Unfit::covered;
    const auto square = face_square(picture, *places);
    return !square || sharpness(*square) < blurred_below ? Unfit::blurred : Unfit::no;
}

} // namespace tp
