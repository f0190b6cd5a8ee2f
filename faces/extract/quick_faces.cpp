// SPDX-License-Identifier: Apache-2.0
#include "faces/extract/quick_faces.hpp"

#include "faces/base/landmarks.hpp"
#include "faces/base/refinement_stage.hpp"
#include "faces/contours/contour_nets.hpp"
#include "faces/decode/quiet_opencv.hpp"
#include "faces/detect/detector.hpp"
#include "faces/detect/embedded_detector.hpp"

#include <algorithm>
#include <utility>

namespace tp {

namespace {

constexpr double same_head = 0.4;    ///< of a face's size; two heads cannot be that near
constexpr double sure_of_face = 0.5; ///< of the points of a face that is judged
constexpr double shut_below = 0.15;  ///< of `openness` (faces/base/landmarks.hpp)

/// Of boxes round one head only the surest.
std::vector<Detection> one_a_head(std::vector<Detection> found) {
    std::stable_sort(found.begin(), found.end(),
                     [](const Detection& a, const Detection& b) { return a.score > b.score; });
    std::vector<Detection> heads;
    for (const Detection& face : found)
        if (std::none_of(heads.begin(), heads.end(), [&face](const Detection& head) {
                return length(head.box.centre() - face.box.centre()) <
                       same_head * std::max(head.size(), face.size());
            }))
            heads.push_back(face);
    return heads;
}

} // namespace

struct QuickFaces::Nets {
    EmbeddedDetector detector;
    ContourNets points{
        RefinementStage::close_looks}; ///< without close looks shut eyes are placed as open ones

    std::optional<Landmarks> sure_points(const cv::Mat& picture, const Detection& face) {
        auto found = points.locate(picture, face);
        return found && found->confidence >= sure_of_face ? std::move(found) : std::nullopt;
    }
};

QuickFaces::QuickFaces() {
    quiet_opencv();
    nets_ = std::make_unique<Nets>();
}
QuickFaces::QuickFaces(QuickFaces&&) noexcept = default;
QuickFaces& QuickFaces::operator=(QuickFaces&&) noexcept = default;
QuickFaces::~QuickFaces() = default;

std::vector<Detection> QuickFaces::find(const cv::Mat& picture) {
    std::vector<Detection> faces = one_a_head(nets_->detector.detect(picture, Effort::usual));
    std::stable_sort(faces.begin(), faces.end(),
                     [](const Detection& a, const Detection& b) { return a.size() > b.size(); });
    return faces;
}

bool QuickFaces::eyes_shut(const cv::Mat& picture, const Detection& face) {
    const auto points = nets_->sure_points(picture, face);
    return points && std::max(openness(points->right_eye), openness(points->left_eye)) < shut_below;
}

std::optional<Face> QuickFaces::face_at(const cv::Mat& picture, const Detection& face) {
    const auto points = nets_->sure_points(picture, face);
    if (!points)
        return std::nullopt;
    Face found;
    found.box = face.box;
    found.score = face.score;
    found.contours = {contour_through(feature::right_eye, points->right_eye, true),
                      contour_through(feature::left_eye, points->left_eye, true),
                      contour_through(feature::outer_lip, points->outer_lip, true),
                      contour_through(feature::outline, points->outline, false)};
    return found;
}

} // namespace tp
