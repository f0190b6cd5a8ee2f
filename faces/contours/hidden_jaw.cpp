// SPDX-License-Identifier: Apache-2.0
#include "faces/contours/hidden_jaw.hpp"

#include "faces/contours/contour_nets.hpp"
#include "faces/contours/crop.hpp"
#include "faces/contours/net_answer.hpp"
#include "faces/models/model_catalog.hpp"

#include <opencv2/core.hpp>

#include <cmath>

namespace tp {
namespace {

constexpr int jaw_px = 64; ///< the net's input; as faces/training/crops.py has it

// A third of those from whom the net learned had a beard, and a third hair before the jaw; fewer people have.
constexpr double least_beard = 0.0, least_hair = 2.5;
constexpr double undecided = 1.5; ///< as near to these, the mirror is asked too

} // namespace

JawCover HiddenJaw::cover(const cv::Mat& picture, const Landmarks& face) {
    const CropFrame frame = outline_frame(face);
    if (picture.empty() || !is_sane(frame, picture))
        return JawCover::none;
    if (!net_)
        net_ = embedded_net(EmbeddedModel::hidden_jaw);
    const cv::Mat pixels = take_crop(picture, frame, jaw_px).pixels;
    auto [beard, hair] = answer_to<2>(*net_, pixels);
    if (std::abs(beard - least_beard) < undecided || std::abs(hair - least_hair) < undecided) {
        cv::Mat mirrored;
        cv::flip(pixels, mirrored, 1);
        const auto other = answer_to<2>(*net_, mirrored);
        beard = 0.5 * (beard + other[0]);
        hair = 0.5 * (hair + other[1]);
    }
    if (beard > least_beard)
        return JawCover::beard;
    return hair > least_hair ? JawCover::hair : JawCover::none;
}

} // namespace tp
