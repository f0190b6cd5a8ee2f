// SPDX-License-Identifier: Apache-2.0
#include "faces/contours/mesh_model.hpp"

#include "core/geometry/polyline.hpp"
#include "faces/contours/crop.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace tp {
namespace {

using Points = std::vector<Vec2>;

constexpr int input_px = 256;
constexpr double window_margin = 1.5;    ///< window per extent of the box, then of the points
constexpr std::size_t skin_points = 468; ///< of 478; the others are the irises
constexpr std::size_t all_points = 478;
constexpr std::size_t mesh_outline_points = 33;
/// Presence on faces is above 12, on false alarms below -2: a half of confidence in
/// between.
constexpr double presence_of_half = 5.0;

// Which of the mesh's points are our features', in the order of `Landmarks`.
constexpr std::array<std::size_t, 16> right_eye{33,  7,   163, 144, 145, 153, 154, 155,
                                                133, 173, 157, 158, 159, 160, 161, 246};
constexpr std::array<std::size_t, 16> left_eye{263, 249, 390, 373, 374, 380, 381, 382,
                                               362, 398, 384, 385, 386, 387, 388, 466};
constexpr std::array<std::size_t, 20> outer_lip{61,  146, 91,  181, 84,  17, 314, 405, 321, 375,
                                                291, 409, 270, 269, 267, 0,  37,  39,  40,  185};
constexpr std::array<std::size_t, 20> inner_lip{78,  95,  88,  178, 87,  14, 317, 402, 318, 324,
                                                308, 415, 310, 311, 312, 13, 82,  81,  80,  191};
constexpr std::array<std::size_t, 10> right_brow{46, 53, 52, 65, 55, 107, 66, 105, 63, 70};
constexpr std::array<std::size_t, 10> left_brow{276, 283, 282, 295, 285, 336, 296, 334, 293, 300};
constexpr std::array<std::size_t, 11> nose{115, 48, 64, 98, 97, 2, 326, 327, 294, 278, 344};
constexpr std::size_t right_iris = 468, left_iris = 473; ///< centres; four points of the rim follow each
// Some of the mesh's own border, the silhouette of which is the outline: ears, jaw, chin.
constexpr std::array<std::size_t, 9> outline_between_passes{127, 93, 58, 136, 152, 365, 288, 323, 356};
constexpr std::size_t right_corner = right_eye[0], left_corner = left_eye[0];

struct MeshAnswer {
    Points points; ///< pixels of the picture
    double presence = 0.0;
};

MeshAnswer run(cv::dnn::Net& net, const cv::Mat& picture, const CropFrame& frame) {
    const Crop crop = take_crop(picture, frame, input_px);
    net.setInput(cv::dnn::blobFromImage(crop.pixels, 1.0 / 255.0, cv::Size(), cv::Scalar(), true));
    std::vector<cv::Mat> outputs;
    net.forward(outputs, std::vector<cv::String>{"t473", "t472"});
    MeshAnswer answer;
    const auto are_numbers = [](const cv::Mat& output) {
        return output.type() == CV_32F && output.isContinuous();
    };
    if (outputs.size() != 2 || !std::ranges::all_of(outputs, are_numbers) ||
        outputs[0].total() != all_points * 3 || outputs[1].empty())
        return answer;
    const float* values = outputs[0].ptr<float>();
    for (std::size_t i = 0; i < all_points; ++i)
        answer.points.push_back(crop.to_picture(Vec2(values[3 * i], values[3 * i + 1])));
    answer.presence = static_cast<double>(*outputs[1].ptr<float>());
    return answer;
}

CropFrame frame_of(const Points& mesh) {
    const Vec2 eyes = mesh[left_corner] - mesh[right_corner];
    const double angle = std::atan2(eyes.y, eyes.x);
    const Vec2 across(std::cos(angle), std::sin(angle)), down(-across.y, across.x);
    Points turned;
    for (std::size_t i = 0; i < skin_points; ++i)
        turned.emplace_back(glm::dot(mesh[i], across), glm::dot(mesh[i], down));
    const Rect extent = bounds_of(turned);
    const Vec2 centre = extent.centre();
    return {centre.x * across + centre.y * down, window_margin * std::max(extent.width(), extent.height()),
            angle};
}

template <std::size_t Count>
Points chosen(const Points& mesh, const std::array<std::size_t, Count>& indices) {
    Points points;
    for (std::size_t i : indices)
        points.push_back(mesh[i]);
    return points;
}

Iris mesh_iris(const Points& mesh, std::size_t centre) {
    double radius = 0.0;
    for (std::size_t i = 1; i <= 4; ++i)
        radius += 0.25 * length(mesh[centre + i] - mesh[centre]);
    return {mesh[centre], radius};
}

/// Mean distance of some points between two answers, px.
template <std::size_t Count>
double moved_px(const Points& one, const Points& other, const std::array<std::size_t, Count>& indices) {
    double sum = 0.0;
    for (std::size_t i : indices)
        sum += length(one[i] - other[i]);
    return sum / static_cast<double>(Count);
}

} // namespace

std::optional<Landmarks> MeshModel::locate(const cv::Mat& picture, const Detection& face) {
    const Vec2 eyes = face.left_eye - face.right_eye;
    CropFrame frame{face.box.centre(), window_margin * face.size(), std::atan2(eyes.y, eyes.x)};
    MeshAnswer answer;
    Points before;
    for (int pass = 0; pass < 2; ++pass) {
        if (!is_sane(frame, picture))
            return std::nullopt;
        before = std::move(answer.points);
        answer = run(net_, picture, frame);
        if (answer.points.empty())
            return std::nullopt;
        frame = frame_of(answer.points);
    }
    for (Vec2 p : answer.points)
        if (!is_finite(p))
            return std::nullopt;
    Landmarks found;
    found.right_eye = chosen(answer.points, right_eye);
    found.left_eye = chosen(answer.points, left_eye);
    found.outer_lip = chosen(answer.points, outer_lip);
    found.inner_lip = chosen(answer.points, inner_lip);
    const Points skin(answer.points.begin(), answer.points.begin() + skin_points);
    found.outline = silhouette_below_eyes(skin, answer.points[right_corner], answer.points[left_corner],
                                          mesh_outline_points);
    if (found.outline.empty())
        return std::nullopt;
    found.right_brow = chosen(answer.points, right_brow);
    found.left_brow = chosen(answer.points, left_brow);
    found.nose = chosen(answer.points, nose);
    found.right_iris = mesh_iris(answer.points, right_iris);
    found.left_iris = mesh_iris(answer.points, left_iris);
    found.confidence = 1.0 / (1.0 + std::exp(presence_of_half - answer.presence));
    found.between_passes_px = {
        moved_px(before, answer.points, right_eye), moved_px(before, answer.points, left_eye),
        moved_px(before, answer.points, outer_lip), moved_px(before, answer.points, inner_lip),
        moved_px(before, answer.points, outline_between_passes)};
    return found;
}

std::vector<Vec2> silhouette_below_eyes(const Points& mesh, Vec2 right, Vec2 left, std::size_t count) {
    const double apart = length(left - right);
    if (!(apart > 0.0) || mesh.size() < 3)
        return {};
    // In the frame of the eyes: x towards the left eye, y down the face.
    const Vec2 across = (left - right) / apart, down(-across.y, across.x), middle = 0.5 * (left + right);
    std::vector<cv::Point2f> flat;
    for (Vec2 p : mesh)
        flat.emplace_back(static_cast<float>(glm::dot(p - middle, across)),
                          static_cast<float>(glm::dot(p - middle, down)));
    std::vector<cv::Point2f> hull;
    cv::convexHull(flat, hull);
    // The hull from the point where it comes down through the eye line on the right eye's side.
    Points below;
    const std::size_t size = hull.size();
    const auto at = [&](std::size_t i) { return Vec2(hull[i % size].x, hull[i % size].y); };
    const auto crossing = [](Vec2 a, Vec2 b) { return a + (b - a) * (a.y / (a.y - b.y)); };
    for (std::size_t i = 0; i < size; ++i)
        if (at(i).y <= 0.0 && at(i + 1).y > 0.0) {
            below.push_back(crossing(at(i), at(i + 1)));
            std::size_t j = i + 1;
            for (; at(j).y > 0.0 && j <= i + size; ++j)
                below.push_back(at(j));
            below.push_back(crossing(at(j), at(j - 1)));
            break;
        }
    if (below.size() < 3)
        return {};
    if (below.front().x > below.back().x)
        std::reverse(below.begin(), below.end());
    Points line = resampled({below, false}, count).points;
    for (Vec2& p : line)
        p = p.x * across + p.y * down + middle;
    return line;
}

} // namespace tp
