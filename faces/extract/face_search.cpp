// SPDX-License-Identifier: Apache-2.0
#include "faces/extract/face_search.hpp"

#include "faces/detect/yunet_detector.hpp"
#include "faces/extract/stopwatch.hpp"
#include "faces/models/model_catalog.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {
namespace {

constexpr double least_confidence = 0.5;
/// Of a face that the mesh alone sees: below what a turned one needs, for it may stand on its side.
constexpr double most_confidence_of_mesh = 0.9;
/// Of a detector, for the mesh to be asked about what the landmarks refuse.
constexpr double least_score_for_mesh = 0.5;
/// The same for the landmarks, and for the mesh, beside a sure face of which it is less than a given share: in
/// a portrait the detector sees small faces in windows, leaves and cloth (faces/FIGURES.md, "In the wild").
constexpr double least_score_beside = 0.5, least_score_for_mesh_beside = 0.75, large_beside = 0.5;
constexpr double same_within = 0.4; ///< of a face's size; two heads cannot be that near

constexpr int other_detector_side =
    640; ///< px, to which a picture is shrunk for it: it finds faces from 10 px on there

bool is_new(const LocatedFace& face, const std::vector<LocatedFace>& known) {
    return std::ranges::none_of(known, [&](const LocatedFace& other) {
        return length(face.centre() - other.centre()) <
               same_within * std::max(face.detection.size(), other.detection.size());
    });
}

/// The other detector finds faces that lie on their side; for them the picture is turned
/// (FaceSearch::turned).
bool lies_on_its_side(const Detection& face) {
    const Vec2 across = face.left_eye - face.right_eye;
    return across.x < std::abs(across.y);
}

bool is_beside_larger(const Detection& face, const std::vector<LocatedFace>& known) {
    return std::ranges::any_of(known, [&](const LocatedFace& other) {
        return other.points.confidence >= least_confidence_turned &&
               face.size() < large_beside * other.detection.size();
    });
}

void sort_by_size(std::vector<LocatedFace>& faces) {
    std::ranges::stable_sort(faces, [](const LocatedFace& a, const LocatedFace& b) {
        return a.detection.size() > b.detection.size();
    });
}

void stop_if_asked(const std::stop_token& stop) {
    if (stop.stop_requested())
        throw SearchStopped();
}

} // namespace

Vec2 LocatedFace::centre() const {
    return 0.25 *
           (points.right_eye[0] + points.left_eye[0] + points.outer_lip[0] + points.outer_lip[mouth_corner]);
}

double surest(const std::vector<LocatedFace>& located) {
    double best = 0.0;
    for (const LocatedFace& face : located)
        best = std::max(best, face.points.confidence);
    return best;
}

std::optional<LocatedFace> FaceSearch::by_landmarks(const cv::Mat& picture, const Detection& detection) {
    auto points = landmarks_.locate(picture, detection);
    if (!points || points->confidence < least_confidence)
        return std::nullopt;
    return LocatedFace{detection, std::move(*points)};
}

std::optional<LocatedFace> FaceSearch::by_mesh(const cv::Mat& picture, const Detection& detection) {
    auto opinions = second_->about(picture, detection, nullptr);
    if (!opinions)
        return std::nullopt;
    opinions->settled.confidence = std::min(opinions->settled.confidence, most_confidence_of_mesh);
    return LocatedFace{detection, std::move(opinions->settled), std::move(opinions->mesh)};
}

/// The detected faces that are confirmed, the largest first. Boxes of different size that led to the same
/// eyes and mouth count once.
std::vector<LocatedFace> FaceSearch::confirmed(const cv::Mat& picture, std::vector<Detection> detections,
                                               By judges, const std::stop_token& stop) {
    std::stable_sort(detections.begin(), detections.end(),
                     [](const Detection& a, const Detection& b) { return a.score > b.score; });
    std::vector<LocatedFace> located;
    for (const Detection& detection : detections) {
        stop_if_asked(stop);
        const bool beside = is_beside_larger(detection, located);
        if (beside && detection.score < least_score_beside)
            continue;
        auto face = by_landmarks(picture, detection);
        if (!face && judges == By::landmarks_and_mesh && second_ &&
            detection.score >= (beside ? least_score_for_mesh_beside : least_score_for_mesh))
            face = by_mesh(picture, detection);
        if (face && is_new(*face, located))
            located.push_back(std::move(*face));
    }
    sort_by_size(located);
    return located;
}

std::vector<LocatedFace> FaceSearch::upright(const cv::Mat& picture, Effort most, SearchTimes& times,
                                             const std::stop_token& stop) {
    const auto detected = [&](Detector& detector, Effort effort, Looks& looks) {
        stop_if_asked(stop);
        Stopwatch watch;
        std::vector<Detection> detections = detector.detect(picture, effort, looks, stop);
        times.detect += watch.lap();
        return detections;
    };
    const auto faces_among = [&](std::vector<Detection> detections) {
        Stopwatch watch;
        std::vector<LocatedFace> faces =
            confirmed(picture, std::move(detections), By::landmarks_and_mesh, stop);
        times.landmarks += watch.lap();
        return faces;
    };
    Looks looks, other_looks;
    const std::vector<Detection> usual = detected(*detector_, Effort::usual, looks);
    std::vector<LocatedFace> located = faces_among(usual);
    if (most == Effort::usual || surest(located) >= least_confidence_turned)
        return located;
    if (second_) {
        YunetDetector other(embedded_net(EmbeddedModel::yunet), other_detector_side);
        std::vector<Detection> by_other = detected(other, Effort::usual, other_looks);
        std::erase_if(by_other, lies_on_its_side);
        for (LocatedFace& face : faces_among(std::move(by_other)))
            if (is_new(face, located))
                located.push_back(std::move(face));
        sort_by_size(located);
    }
    if (!located.empty())
        return located;
    if (second_)
        second_->rest();
    std::vector<Detection> thorough = detected(*detector_, Effort::thorough, looks);
    std::erase_if(thorough, [&](const Detection& detection) { // the landmarks would say the same again
        return std::ranges::find(usual, detection) != usual.end();
    });
    return faces_among(std::move(thorough));
}

std::vector<LocatedFace> FaceSearch::turned(const cv::Mat& picture, SearchTimes& times,
                                            const std::stop_token& stop) {
    stop_if_asked(stop);
    Stopwatch watch;
    const std::vector<Detection> detections = detector_->detect(picture, Effort::usual, stop);
    times.detect += watch.lap();
    std::vector<LocatedFace> located = confirmed(picture, detections, By::landmarks, stop);
    times.landmarks += watch.lap();
    std::erase_if(located,
                  [](const LocatedFace& face) { return face.points.confidence < least_confidence_turned; });
    return located;
}

} // namespace tp
