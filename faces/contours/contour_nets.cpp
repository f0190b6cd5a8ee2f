// SPDX-License-Identifier: Apache-2.0
#include "faces/contours/contour_nets.hpp"

#include "core/geometry/polyline.hpp"
#include "faces/contours/net_points.hpp"
#include "faces/contours/plausibility.hpp"
#include "faces/contours/shrunk.hpp"
#include "faces/models/model_catalog.hpp"

#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

// Inputs of the nets, px, and how much of the picture they were trained to see.
constexpr int face_px = 128, eye_px = 64, mouth_px = 96, outline_px = 96;
constexpr double face_by_box = 1.25;    ///< window per longer side of the detected box
constexpr double face_by_points = 1.45; ///< window per extent of the points, second pass
constexpr double eye_by_width = 2.0, mouth_by_extent = 1.6, outline_by_extent = 1.35;
/// A face this large, px, has eyes of 60 px, of which a net sees 32: more of it would only take time.
constexpr double large_enough_px = 300.0;

using Points = std::vector<Vec2>;

Points part(const Points& points, PointRange range) {
    return {points.begin() + static_cast<std::ptrdiff_t>(range.begin),
            points.begin() + static_cast<std::ptrdiff_t>(range.end)};
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

/// Upright along the eyes, `margin` times as large as some points of a face.
CropFrame face_frame(const Points& points, PointRange around, double margin) {
    const Vec2 eyes = points[net_points::left_eye.begin] - points[net_points::right_eye.begin];
    return frame_around(part(points, around), angle_of(eyes), margin);
}

/// Both eyes as a right eye: the left one is seen in a mirror.
CropFrame eye_frame(const Points& eye, bool mirrored) {
    const Vec2 outwards_in = eye[eye_corner] - eye[0];
    const Vec2 along = mirrored ? -outwards_in : outwards_in;
    return {bounds_of(eye).centre(), eye_by_width * length(along), angle_of(along), mirrored};
}

Points felt_points(const Landmarks& face) {
    Points all;
    for (const Points* line :
         {&face.right_eye, &face.left_eye, &face.outer_lip, &face.inner_lip, &face.outline})
        all.insert(all.end(), line->begin(), line->end());
    return all;
}

CropFrame mouth_frame(const Points& lips) {
    return frame_around(lips, angle_of(lips[mouth_corner] - lips[0]), mouth_by_extent);
}

/// Mean distance of some points of two placements of a face, px.
double moved_px(const Points& one, const Points& other, PointRange range) {
    double sum = 0.0;
    for (std::size_t i = range.begin; i < range.end; ++i)
        sum += length(one[i] - other[i]);
    return sum / static_cast<double>(range.size());
}

/// Mean distance of points to a line, px: a point that slid along an outline is as right as before.
double off_line_px(const Points& points, const Points& line) {
    double sum = 0.0;
    for (Vec2 p : points)
        sum += distance_to({line, false}, p);
    return sum / static_cast<double>(points.size());
}

/// From what a net answers, fractions of the window's side from its middle, to px of the picture; nothing
/// where that is not finite.
std::optional<Points> placed(Points offsets, const Crop& crop) {
    for (Vec2& p : offsets) {
        p = crop.to_picture((p + 0.5) * static_cast<double>(crop.pixels.cols));
        if (!is_finite(p))
            return std::nullopt;
    }
    return offsets;
}

double mean_of(const std::vector<double>& values, PointRange range) {
    double sum = 0.0;
    for (std::size_t i = range.begin; i < range.end; ++i)
        sum += values[i];
    return sum / static_cast<double>(range.size());
}

Iris iris_at(const Points& points, std::size_t which) {
    const Vec2 centre = points[net_points::irises.begin + which];
    return {centre, length(points[net_points::rims.begin + which] - centre)};
}

Landmarks features_of(const Points& points) {
    using namespace net_points;
    Landmarks found;
    found.right_eye = part(points, right_eye);
    found.left_eye = part(points, left_eye);
    found.outer_lip = part(points, outer_lip);
    found.inner_lip = part(points, inner_lip);
    found.outline = part(points, outline);
    found.right_brow = part(points, right_brow);
    found.left_brow = part(points, left_brow);
    found.nose = part(points, nose);
    found.right_iris = iris_at(points, 0);
    found.left_iris = iris_at(points, 1);
    return found;
}

/// Back: as net_points::all; fewer where the other model knows no brows or nose.
Points points_of(const Landmarks& face) {
    Points points;
    for (const Points* line :
         {&face.right_eye, &face.left_eye, &face.outer_lip, &face.inner_lip, &face.outline})
        points.insert(points.end(), line->begin(), line->end());
    const Vec2 across = face.left_iris.centre - face.right_iris.centre;
    const Vec2 outwards = length(across) > 0.0 ? across / length(across) : Vec2(0.0);
    points.push_back(face.right_iris.centre);
    points.push_back(face.left_iris.centre);
    points.push_back(face.right_iris.centre - face.right_iris.radius * outwards);
    points.push_back(face.left_iris.centre + face.left_iris.radius * outwards);
    for (const Points* line : {&face.right_brow, &face.left_brow, &face.nose})
        points.insert(points.end(), line->begin(), line->end());
    return points;
}

/// As FeatureIndex.
constexpr PointRange features[] = {net_points::right_eye, net_points::left_eye, net_points::outer_lip,
                                   net_points::inner_lip, net_points::outline};

Landmarks unverified(const Points& points) {
    Landmarks found = features_of(points);
    found.confidence = 1.0;
    return found;
}

void replace(Points& points, PointRange range, const Points& by) {
    std::copy(by.begin(), by.end(), points.begin() + static_cast<std::ptrdiff_t>(range.begin));
}

} // namespace

CropFrame outline_frame(const Landmarks& face) {
    return frame_around(felt_points(face), angle_of(face.left_eye[0] - face.right_eye[0]), outline_by_extent);
}

ContourNets::ContourNets(RefinementStage most)
    : most_(most), face_(embedded_net(EmbeddedModel::contours)), eye_(embedded_net(EmbeddedModel::eye)),
      mouth_(embedded_net(EmbeddedModel::mouth)), outline_(embedded_net(EmbeddedModel::outline)) {}

Points ContourNets::answer(cv::dnn::Net& net, const cv::Mat& pixels) {
    net.setInput(cv::dnn::blobFromImage(pixels, 1.0 / 255.0, cv::Size(), cv::Scalar::all(127.5)));
    const cv::Mat output = net.forward();
    const float* values = output.ptr<float>();
    Points offsets(output.total() / 2);
    for (std::size_t i = 0; i < offsets.size(); ++i)
        offsets[i] = Vec2(values[2 * i], values[2 * i + 1]);
    return offsets;
}

std::optional<Points> ContourNets::look(cv::dnn::Net& net, const cv::Mat& picture, const CropFrame& frame,
                                        int size) {
    if (!is_sane(frame, picture))
        return std::nullopt;
    const Crop crop = take_crop(picture, frame, size);
    return placed(answer(net, crop.pixels), crop);
}

/// `first` is the number among net_points of the net's first point.
std::optional<ContourNets::BothWays> ContourNets::look_both_ways(cv::dnn::Net& net, const cv::Mat& picture,
                                                                 const CropFrame& frame, int size,
                                                                 std::size_t first) {
    if (!is_sane(frame, picture))
        return std::nullopt;
    const Crop crop = take_crop(picture, frame, size);
    Points offsets = answer(net, crop.pixels);
    cv::Mat mirrored;
    cv::flip(crop.pixels, mirrored, 1);
    const Points other = answer(net, mirrored);
    std::vector<double> apart;
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        const Vec2 back = Vec2(-1.0, 1.0) * other[in_mirror(first + i) - first];
        apart.push_back(frame.side * length(offsets[i] - back));
        offsets[i] = 0.5 * (offsets[i] + back);
    }
    auto points = placed(std::move(offsets), crop);
    if (!points)
        return std::nullopt;
    return BothWays{std::move(*points), std::move(apart)};
}

std::optional<Landmarks> ContourNets::locate(const cv::Mat& picture, const Detection& face) {
    const Shrunk near = shrunk_around(picture, face, large_enough_px);
    auto found = locate_in(near.pixels, near.face);
    if (found)
        map_points(*found, near.to_picture, near.scale());
    return found;
}

std::optional<Landmarks> ContourNets::locate_in(const cv::Mat& picture, const Detection& face) {
    using namespace net_points;
    const auto coarse = look(face_, picture, face_frame(face), face_px);
    if (!coarse || coarse->size() != all.size())
        return std::nullopt;
    if (most_ == RefinementStage::first_look)
        return unverified(*coarse);
    const CropFrame face_window = face_frame(*coarse, windowed, face_by_points);
    const auto seen = look_both_ways(face_, picture, face_window, face_px, 0);
    if (!seen)
        return std::nullopt;
    const Points& fine = seen->points;
    if (most_ == RefinementStage::second_look)
        return unverified(fine);
    Steadiness steadiness{.between_passes = disagreement(part(*coarse, windowed), part(fine, windowed)),
                          .between_mirrors = mean_of(seen->apart, all) / face_window.side};
    if (is_unsteady(steadiness))
        return std::nullopt;
    auto found = look_closely_in(picture, fine);
    if (!found)
        return std::nullopt;
    for (std::size_t f = 0; f < feature_count; ++f)
        found->between_passes_px[f] = moved_px(*coarse, fine, features[f]);
    for (const FeatureIndex eye : {at_right_eye, at_left_eye})
        found->between_mirrors_px[eye] = mean_of(seen->apart, features[eye]);
    const Points closest = points_of(*found);
    steadiness.between_nets = disagreement(part(fine, {0, lips.end}), part(closest, {0, lips.end}));
    found->confidence = confidence_of(*found, steadiness);
    return found;
}

std::optional<Landmarks> ContourNets::look_closely(const cv::Mat& picture, const Detection& face,
                                                   const Landmarks& start) {
    const Shrunk near = shrunk_around(picture, face, large_enough_px);
    Landmarks there = start;
    map_points(there, near.to_picture.inverse().value(), 1.0 / near.scale());
    const Points from = points_of(there);
    if (from.size() != net_points::all.size())
        return std::nullopt;
    auto found = look_closely_in(near.pixels, from);
    if (!found)
        return std::nullopt;
    map_points(*found, near.to_picture, near.scale());
    found->confidence = start.confidence;
    return found;
}

/// `fine`: as net_points::all.
std::optional<Landmarks> ContourNets::look_closely_in(const cv::Mat& picture, const Points& fine) {
    using namespace net_points;
    const auto right_eye_close = look(eye_, picture, eye_frame(part(fine, right_eye), false), eye_px);
    const auto left_eye_close = look(eye_, picture, eye_frame(part(fine, left_eye), true), eye_px);
    const auto lips_close =
        look_both_ways(mouth_, picture, mouth_frame(part(fine, lips)), mouth_px, lips.begin);
    const auto outline_close = look_both_ways(outline_, picture, face_frame(fine, felt, outline_by_extent),
                                              outline_px, outline.begin);
    if (!right_eye_close || !left_eye_close || !lips_close || !outline_close)
        return std::nullopt;
    Points closest = fine;
    replace(closest, right_eye, *right_eye_close);
    replace(closest, left_eye, *left_eye_close);
    replace(closest, lips, lips_close->points);
    replace(closest, outline, outline_close->points);
    Landmarks found = features_of(closest);
    for (std::size_t f = 0; f < feature_count; ++f)
        if (f != at_outline)
            found.between_nets_px[f] = moved_px(fine, closest, features[f]);
    found.between_nets_px[at_outline] = off_line_px(found.outline, part(fine, outline));
    found.between_mirrors_px[at_outer_lip] = mean_of(lips_close->apart, {0, outer_lip.size()});
    found.between_mirrors_px[at_inner_lip] = mean_of(lips_close->apart, {outer_lip.size(), lips.size()});
    found.between_mirrors_px[at_outline] = mean_of(outline_close->apart, {0, outline.size()});
    return found;
}

} // namespace tp
