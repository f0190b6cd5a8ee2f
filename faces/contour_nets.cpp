// SPDX-License-Identifier: Apache-2.0
#include "faces/contour_nets.hpp"

#include "core/geometry/polyline.hpp"
#include "faces/model_catalog.hpp"
#include "faces/plausibility.hpp"

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

// Inputs of the nets, px, and how much of the picture they were trained to see.
constexpr int face_px = 128, eye_px = 64, mouth_px = 96, outline_px = 96;
constexpr double face_by_box = 1.25;    ///< window per longer side of the detected box
constexpr double face_by_points = 1.45; ///< window per extent of the points, second pass
constexpr double eye_by_width = 2.0, mouth_by_extent = 1.6, outline_by_extent = 1.35;

// How the points of the face net are numbered.
constexpr std::size_t right_eye_at = 0, left_eye_at = 16, outer_lip_at = 32, inner_lip_at = 52,
                      outline_at = 72, irises_at = 105, point_count = 107;

using Points = std::vector<Vec2>;

Points part(const Points& points, std::size_t begin, std::size_t end) {
    return {points.begin() + static_cast<std::ptrdiff_t>(begin),
            points.begin() + static_cast<std::ptrdiff_t>(end)};
}

double angle_of(Vec2 v) { return std::atan2(v.y, v.x); }

/// A window upright along `angle` around the points, `margin` times their larger extent.
CropFrame frame_around(const Points& points, double angle, double margin) {
    const Vec2 across(std::cos(angle), std::sin(angle)), down(-across.y, across.x);
    Points turned;
    for (Vec2 p : points)
        turned.emplace_back(glm::dot(p, across), glm::dot(p, down));
    const Rect extent = bounds_of(turned);
    const Vec2 centre = extent.centre();
    return {centre.x * across + centre.y * down, margin * std::max(extent.width(), extent.height()), angle};
}

CropFrame face_frame(const Detection& face) {
    return {face.box.centre(), face_by_box * face.size(), angle_of(face.left_eye - face.right_eye)};
}

/// Upright along the eyes, `margin` times as large as all points of a face.
CropFrame face_frame(const Points& points, double margin) {
    return frame_around(points, angle_of(points[left_eye_at] - points[right_eye_at]), margin);
}

/// Both eyes as a right eye: the left one is seen in a mirror.
CropFrame eye_frame(const Points& eye, bool mirrored) {
    const Vec2 outwards_in = eye[eye_corner] - eye[0];
    const Vec2 along = mirrored ? -outwards_in : outwards_in;
    return {bounds_of(eye).centre(), eye_by_width * length(along), angle_of(along), mirrored};
}

/// Mean distance of the points [begin, end) of two placements of a face, px.
double moved_px(const Points& one, const Points& other, std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i)
        sum += length(one[i] - other[i]);
    return sum / static_cast<double>(end - begin);
}

CropFrame mouth_frame(const Points& lips) {
    return frame_around(lips, angle_of(lips[mouth_corner] - lips[0]), mouth_by_extent);
}

} // namespace

ContourNets::ContourNets()
    : face_(embedded_net(EmbeddedModel::contours)), eye_(embedded_net(EmbeddedModel::eye)),
      mouth_(embedded_net(EmbeddedModel::mouth)), outline_(embedded_net(EmbeddedModel::outline)) {}

std::optional<std::vector<Vec2>> ContourNets::points_in(cv::dnn::Net& net, const cv::Mat& picture,
                                                        const CropFrame& frame, int size) {
    if (!is_sane(frame, picture))
        return std::nullopt;
    const Crop crop = take_crop(picture, frame, size);
    net.setInput(cv::dnn::blobFromImage(crop.pixels, 1.0 / 255.0, cv::Size(), cv::Scalar::all(127.5)));
    const cv::Mat output = net.forward();
    const float* values = output.ptr<float>();
    Points points(output.total() / 2);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 offset(values[2 * i], values[2 * i + 1]); // from the window's middle, in window sides
        points[i] = crop.to_picture((offset + 0.5) * static_cast<double>(size));
        if (!is_finite(points[i]))
            return std::nullopt;
    }
    return points;
}

std::optional<Landmarks> ContourNets::locate(const cv::Mat& picture, const Detection& face) {
    const auto coarse = points_in(face_, picture, face_frame(face), face_px);
    if (!coarse || coarse->size() != point_count)
        return std::nullopt;
    const auto fine = points_in(face_, picture, face_frame(*coarse, face_by_points), face_px);
    if (!fine)
        return std::nullopt;
    const double between_passes = disagreement(*coarse, *fine);
    if (is_unsteady(between_passes))
        return std::nullopt;
    const Points right_eye = part(*fine, right_eye_at, left_eye_at);
    const Points left_eye = part(*fine, left_eye_at, outer_lip_at);
    const Points lips = part(*fine, outer_lip_at, outline_at);
    const auto right_eye_close = points_in(eye_, picture, eye_frame(right_eye, false), eye_px);
    const auto left_eye_close = points_in(eye_, picture, eye_frame(left_eye, true), eye_px);
    const auto lips_close = points_in(mouth_, picture, mouth_frame(lips), mouth_px);
    const auto outline_close =
        points_in(outline_, picture, face_frame(part(*fine, 0, irises_at), outline_by_extent), outline_px);
    if (!right_eye_close || !left_eye_close || !lips_close || !outline_close)
        return std::nullopt;

    Landmarks found;
    found.right_eye = *right_eye_close;
    found.left_eye = *left_eye_close;
    found.outer_lip = part(*lips_close, 0, inner_lip_at - outer_lip_at);
    found.inner_lip = part(*lips_close, inner_lip_at - outer_lip_at, lips_close->size());
    found.outline = *outline_close;
    Points closer = *right_eye_close;
    closer.insert(closer.end(), left_eye_close->begin(), left_eye_close->end());
    closer.insert(closer.end(), lips_close->begin(), lips_close->end());
    const Points before = part(*fine, 0, outline_at);
    constexpr std::size_t borders[] = {right_eye_at, left_eye_at, outer_lip_at,
                                       inner_lip_at, outline_at,  irises_at}; // as FeatureIndex
    for (std::size_t f = 0; f < feature_count; ++f) {
        found.between_passes_px[f] = moved_px(*coarse, *fine, borders[f], borders[f + 1]);
        if (f != at_outline)
            found.between_nets_px[f] = moved_px(before, closer, borders[f], borders[f + 1]);
    }
    found.confidence = confidence_of(found, between_passes, disagreement(before, closer));
    return found;
}

} // namespace tp
