// SPDX-License-Identifier: Apache-2.0
#include "faces/contours/dark_glasses.hpp"

#include "faces/contours/crop.hpp"
#include "faces/contours/net_answer.hpp"
#include "faces/models/model_catalog.hpp"

#include <opencv2/core.hpp>

#include <cmath>
#include <limits>

namespace tp {
namespace {

// As faces/training/crops.py has them: the net's input, px, and its window per distance of the eyes' outer corners.
constexpr int eyes_px = 64;
constexpr double eyes_by_apart = 1.9;
constexpr double least_apart_px = 30.0; ///< below, nothing about a face is clear

} // namespace

double DarkGlasses::evidence(const cv::Mat& picture, const Landmarks& face) {
    constexpr double none = -std::numeric_limits<double>::infinity();
    const Vec2 right = face.right_eye[0], across = face.left_eye[0] - right;
    const CropFrame frame{right + 0.5 * across, eyes_by_apart * length(across),
                          std::atan2(across.y, across.x)};
    if (!(length(across) >= least_apart_px) || !is_sane(frame, picture))
        return none;
    if (!net_)
        net_ = embedded_net(EmbeddedModel::dark_glasses);
    const cv::Mat pixels = take_crop(picture, frame, eyes_px).pixels;
    cv::Mat mirrored;
    cv::flip(pixels, mirrored, 1);
    const double mean = 0.5 * (answer_to<1>(*net_, pixels)[0] + answer_to<1>(*net_, mirrored)[0]);
    return std::isfinite(mean) ? mean : none;
}

} // namespace tp
