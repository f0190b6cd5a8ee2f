// SPDX-License-Identifier: Apache-2.0
#include "model_file_check.hpp"

#include "faces/contours/lbf_model.hpp"
#include "faces/contours/mesh_model.hpp"
#include "faces/detect/haar_detector.hpp"
#include "faces/detect/yunet_detector.hpp"
#include "memory_folder.hpp"

#include <opencv2/imgproc.hpp>

#include <array>
#include <filesystem>
#include <functional>

namespace tp::test {
namespace {

namespace fs = std::filesystem;

constexpr int points = 68, leaves = 2;
constexpr std::size_t seldom = 4; ///< of so many facemarks one places a face: our own nets look at it too

bool taken = false;

fs::path written(const char* name, std::string_view bytes) {
    static const MemoryFolder folder;
    return folder.file(name, bytes);
}

/// A bright square on dark ground and a slope, of other sizes than what loading shows.
const std::array<cv::Mat, 2>& pictures() {
    static const std::array<cv::Mat, 2> both = [] {
        cv::Mat square(90, 120, CV_8UC3, cv::Scalar::all(20)), slope(75, 61, CV_8UC3);
        cv::rectangle(square, {40, 20, 50, 50}, cv::Scalar::all(230), cv::FILLED);
        for (int y = 0; y < slope.rows; ++y)
            slope.row(y).setTo(cv::Scalar(3 * y, 255 - 2 * y, y));
        return std::array<cv::Mat, 2>{square, slope};
    }();
    return both;
}

std::string complaint_about_detector(Result<std::unique_ptr<Detector>> loaded) {
    if (!loaded)
        return loaded.error().ends_with("that can be used.") ? "" : "no sentence: " + loaded.error();
    taken = true;
    for (const cv::Mat& picture : pictures())
        for (const Effort effort : {Effort::usual, Effort::thorough})
            try {
                for (const Detection& face : (*loaded)->detect(picture, effort))
                    for (const Vec2 p : {face.box.min, face.box.max, face.right_eye, face.left_eye})
                        if (!is_finite(p))
                            return "a face that is nowhere";
            } catch (const std::exception&) { // what FaceExtractor tells in a sentence
            }
    return {};
}

std::string complaint_about_landmarks(Result<std::unique_ptr<LandmarkModel>> loaded, bool look) {
    if (!loaded)
        return loaded.error().ends_with("that can be used.") ? "" : "no sentence: " + loaded.error();
    taken = true;
    for (const cv::Mat& picture : pictures()) {
        if (!look)
            break;
        try {
            const auto found = (*loaded)->locate(picture, {{{20, 10}, {60, 60}}, {30, 30}, {50, 31}, 1.0});
            if (!found)
                continue;
            for (const auto* line :
                 {&found->right_eye, &found->left_eye, &found->outer_lip, &found->inner_lip, &found->outline,
                  &found->right_brow, &found->left_brow, &found->nose})
                for (const Vec2 p : *line)
                    if (!is_finite(p))
                        return "a point that is nowhere";
        } catch (const std::exception&) { // what FaceExtractor tells in a sentence
        }
    }
    return {};
}

/// What follows the beginning of a small facemark.
std::string rest_of_facemark() {
    std::string text;
    const auto table = [&text](const std::string& name, int rows, int columns) {
        text += name + ": !!opencv-matrix\n   rows: " + std::to_string(rows) +
                "\n   cols: " + std::to_string(columns) + "\n   dt: d\n   data: [ 0.";
        for (int i = 1; i < rows * columns; ++i)
            text += i % 40 == 0 ? ",\n      0." : ",0.";
        text += " ]\n";
    };
    for (int point = 1; point < points; ++point) {
        const std::string place = "_0_" + std::to_string(point) + "_0";
        table("tree" + place, 2 * leaves, 4);
        text += "thresholds" + place + ": [ 0, 0, 0, 0 ]\n";
    }
    table("weights_0", 2 * points, points * leaves);
    return text;
}

} // namespace

std::string complaint_about_onnx_file(std::string_view bytes) {
    taken = false;
    const fs::path file = written("net.onnx", bytes);
    const std::string mesh = complaint_about_landmarks(MeshModel::load(file), true);
    return mesh.empty() ? complaint_about_detector(YunetDetector::load(file)) : mesh;
}

std::string complaint_about_haar_file(std::string_view bytes) {
    taken = false;
    return complaint_about_detector(HaarDetector::load(written("cascade.xml", bytes)));
}

std::string complaint_about_lbf_file(std::string_view begin) {
    taken = false;
    static const std::string rest = rest_of_facemark();
    return complaint_about_landmarks(LbfModel::load(written("facemark.yaml", std::string(begin) + rest)),
                                     std::hash<std::string_view>{}(begin) % seldom == 0);
}

bool last_was_taken() { return taken; }

} // namespace tp::test
