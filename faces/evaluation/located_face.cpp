// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/located_face.hpp"

#include "faces/base/face.hpp"
#include "faces/pieces/contour_fit.hpp"

#include <algorithm>

namespace tp {
namespace {

constexpr double least_confidence = 0.5; ///< as in the extractor

} // namespace

std::vector<Contour> contours_of(const FaceLines& lines) {
    const auto opening = [](const char* name, const Opening& edges) {
        const std::size_t corner = edges.lower.size() - 1;
        return fit_contour(name, uncrossed(edges.around(), corner), true, {0, corner});
    };
    return {opening(feature::right_eye, lines.right_eye), opening(feature::left_eye, lines.left_eye),
            opening(feature::outer_lip, lines.outer_lip), opening(feature::inner_lip, lines.inner_lip),
            fit_contour(feature::outline, lines.outline, false)};
}

std::optional<Landmarks> located(LandmarkModel& model, const cv::Mat& picture,
                                 const std::vector<Detection>& places) {
    for (const Detection& place : places)
        if (auto found = model.locate(picture, place); found && found->confidence >= least_confidence)
            return found;
    return std::nullopt;
}

std::vector<Detection> surest_first(Detector& detector, const cv::Mat& picture) {
    Looks looks;
    std::vector<Detection> places = detector.detect(picture, Effort::usual, looks, {});
    if (places.empty())
        places = detector.detect(picture, Effort::thorough, looks, {});
    std::sort(places.begin(), places.end(),
              [](const Detection& a, const Detection& b) { return a.score > b.score; });
    return places;
}

} // namespace tp
