// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/contours/lbf_model.hpp"
#include "faces/decode/picture.hpp"
#include "faces/detect/embedded_detector.hpp"
#include "places.hpp"

#include <string>
#include <vector>

/// A small LBF facemark, for tests that need one: OpenCV learns it from drawn portraits.
namespace drawn_facemark {

using namespace tp;
using Points = std::vector<Vec2>;

inline constexpr const char* drawn_people[] = {"anna_angry", "anna_sad",    "anna_smiling", "anna_surprised",
                                               "ben_angry",  "ben_smiling", "clara_sad"};

struct DrawnFace {
    cv::Mat picture;
    Detection detection;
    Landmarks points; ///< as our own nets place them
};

inline std::vector<DrawnFace> drawn_faces() {
    EmbeddedDetector detector;
    ContourNets nets;
    std::vector<DrawnFace> faces;
    for (const char* name : drawn_people) {
        DrawnFace face;
        face.picture =
            read_picture(std::string(tp::test::in_source("resources/samples/")) + name + ".jpg").value();
        face.detection = detector.detect(face.picture, Effort::usual).at(0);
        face.points = nets.locate(face.picture, face.detection).value();
        faces.push_back(face);
    }
    return faces;
}

/// iBUG's 68 points of a face, those of brows and nose roughly.
inline std::vector<cv::Point2f> points_68(const Landmarks& face) {
    Points p;
    const auto add = [&](const Points& line, std::initializer_list<std::size_t> numbers) {
        for (const std::size_t i : numbers)
            p.push_back(line[i]);
    };
    add(face.outline, {0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30, 32});
    add(face.right_brow, {0, 1, 2, 3, 4});
    add(face.left_brow, {4, 3, 2, 1, 0});
    const Vec2 between = 0.5 * (face.right_eye[eye_corner] + face.left_eye[eye_corner]);
    for (int i = 0; i < 4; ++i)
        p.push_back(between + 0.25 * i * (face.nose[5] - between));
    add(face.nose, {2, 4, 5, 6, 8});
    add(face.right_eye, {0, 13, 11, 8, 5, 3});
    add(face.left_eye, {8, 11, 13, 0, 3, 5});
    add(face.outer_lip, {0, 18, 17, 15, 13, 12, 10, 8, 7, 5, 3, 2});
    add(face.inner_lip, {0, 17, 15, 13, 10, 7, 5, 3});
    std::vector<cv::Point2f> points;
    for (const Vec2 q : p)
        points.emplace_back(static_cast<float>(q.x - 0.5), static_cast<float>(q.y - 0.5));
    return points;
}

/// What training asks: the box of the face that is being added.
inline bool box_of(cv::InputArray, cv::OutputArray boxes, void* detection) {
    const auto& face = *static_cast<const Detection*>(detection);
    const Vec2 corner = face.box.min;
    const std::vector<cv::Rect> box{{static_cast<int>(corner.x), static_cast<int>(corner.y),
                                     static_cast<int>(face.size()), static_cast<int>(face.size())}};
    cv::Mat(box).copyTo(boxes);
    return true;
}

/// A small facemark that OpenCV learns from the drawn faces.
inline void train(const std::vector<DrawnFace>& faces, const std::string& file) {
    cv::face::FacemarkLBF::Params params;
    params.verbose = false;
    params.cascade_face = "none"; // asked for, but not used
    params.model_filename = file;
    params.stages_n = 2;
    params.tree_n = 3;
    params.tree_depth = 3;
    params.initShape_n = 4;
    params.feats_m.assign(10, 40);
    const auto facemark = cv::face::FacemarkLBF::create(params);
    for (const DrawnFace& face : faces) {
        Detection detection = face.detection;
        facemark->setFaceDetector(box_of, &detection);
        facemark->addTrainingSample(face.picture, points_68(face.points));
    }
    facemark->training();
}

} // namespace drawn_facemark
