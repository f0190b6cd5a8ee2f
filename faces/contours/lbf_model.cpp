// SPDX-License-Identifier: Apache-2.0
#include "faces/contours/lbf_model.hpp"

#include "core/geometry/polyline.hpp"
#include "faces/contours/crop.hpp"
#include "faces/contours/plausibility.hpp"
#include "faces/decode/quiet_opencv.hpp"
#include "faces/models/lbf_file.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <initializer_list>

namespace tp {
namespace {

using Points = std::vector<Vec2>;

constexpr int box_px = 256; ///< the box in which the facemark looks; it sees half a box around it too
constexpr int window_px = 2 * box_px;
constexpr std::size_t lid_points = 9, lip_points = 11, outline_samples = 33; ///< both ends counted

// Numbers of iBUG's points (300-W), from 0.
constexpr std::size_t ibug_right_eye = 36, ibug_left_eye = 42, ibug_eye_end = 48;

std::complex<double> number(Vec2 v) { return {v.x, v.y}; }
Vec2 vector(std::complex<double> z) { return {z.real(), z.imag()}; }

Vec2 mean_of(const Points& points, std::size_t begin, std::size_t end) {
    Vec2 sum(0.0);
    for (std::size_t i = begin; i < end; ++i)
        sum += points[i];
    return sum / static_cast<double>(end - begin);
}

/// z → turned_and_scaled z + offset
Affine similarity(std::complex<double> turned_and_scaled, Vec2 offset) {
    const double re = turned_and_scaled.real(), im = turned_and_scaled.imag();
    return {glm::dmat2(re, im, -im, re), offset};
}

Affine by_eyes(const Points& mean, const Detection& face) {
    const Vec2 right = mean_of(mean, ibug_right_eye, ibug_left_eye), left = mean_of(mean, ibug_left_eye, ibug_eye_end);
    const auto map = number(face.left_eye - face.right_eye) / number(left - right);
    return similarity(map, face.right_eye - vector(map * number(right)));
}

/// Least squares.
Affine best_fit(const Points& mean, const Points& points) {
    const Vec2 from = mean_of(mean, 0, mean.size()), to = mean_of(points, 0, points.size());
    std::complex<double> common = 0.0;
    double own = 0.0;
    for (std::size_t i = 0; i < mean.size(); ++i) {
        common += std::conj(number(mean[i] - from)) * number(points[i] - to);
        own += std::norm(number(mean[i] - from));
    }
    const auto map = common / own;
    return similarity(map, to - vector(map * number(from)));
}

/// `count` points at equal distances along the cubic Hermite spline through some of `points`, with the slopes
/// of the parabola through three neighbours.
Points rounded(std::span<const Vec2> points, std::initializer_list<std::size_t> numbers, std::size_t count) {
    constexpr int steps = 12; ///< between two points
    Points through;
    for (const std::size_t i : numbers)
        if (through.empty() || points[i] != through.back())
            through.push_back(points[i]);
    const std::size_t last = through.size() - 1;
    if (through.size() < 3)
        return Points(count, points[*numbers.begin()]);
    const auto chord = [&](std::size_t i) { return length(through[i + 1] - through[i]); };
    const auto rise = [&](std::size_t i) { return (through[i + 1] - through[i]) / chord(i); };
    Points slope(through.size());
    for (std::size_t i = 1; i < last; ++i)
        slope[i] = (chord(i) * rise(i - 1) + chord(i - 1) * rise(i)) / (chord(i - 1) + chord(i));
    slope[0] = 2.0 * rise(0) - slope[1];
    slope[last] = 2.0 * rise(last - 1) - slope[last - 1];
    Points line{through[0]};
    for (std::size_t i = 0; i < last; ++i)
        for (int k = 1; k <= steps; ++k) {
            const double t = static_cast<double>(k) / steps, u = 1.0 - t;
            line.push_back(u * u * (1.0 + 2.0 * t) * through[i] + t * t * (1.0 + 2.0 * u) * through[i + 1] +
                           chord(i) * t * u * (u * slope[i] - t * slope[i + 1]));
        }
    return resampled({std::move(line), false}, count).points;
}

/// A closed line of two that meet at both ends.
Points around(Points there, const Points& back) {
    there.insert(there.end(), back.begin() + 1, back.end() - 1);
    return there;
}

double moved_px(const Points& one, const Points& other) {
    double sum = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i)
        sum += length(one[i] - other[i]);
    return sum / static_cast<double>(one.size());
}

} // namespace

Landmarks features_of_68(std::span<const Vec2> p) {
    Landmarks found;
    found.right_eye =
        around(rounded(p, {36, 41, 40, 39}, lid_points), rounded(p, {39, 38, 37, 36}, lid_points));
    found.left_eye =
        around(rounded(p, {45, 46, 47, 42}, lid_points), rounded(p, {42, 43, 44, 45}, lid_points));
    found.outer_lip = around(rounded(p, {48, 59, 58, 57, 56, 55, 54}, lip_points),
                             rounded(p, {54, 53, 52, 51, 50, 49, 48}, lip_points));
    found.inner_lip =
        around(rounded(p, {60, 67, 66, 65, 64}, lip_points), rounded(p, {64, 63, 62, 61, 60}, lip_points));
    found.outline = rounded(p, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}, outline_samples);
    return found;
}

Result<std::unique_ptr<LandmarkModel>> LbfModel::load(const std::filesystem::path& file) {
    const Error unusable{"The file \"" + file.string() +
                         "\" is not an LBF facemark of 68 points that can be used."};
    try {
        quiet_opencv();
        const HushedThread hushed;
        auto mean = lbf_mean_shape(file);
        if (!mean)
            return unusable;
        cv::face::FacemarkLBF::Params params;
        params.verbose = false;
        auto facemark = cv::face::FacemarkLBF::create(params);
        facemark->loadModel(file.string());
        auto model = std::make_unique<LbfModel>(std::move(facemark), std::move(*mean));
        const cv::Mat blank = cv::Mat::zeros(64, 64, CV_8UC3);
        if (!model->look(blank, similarity(16.0, Vec2(32.0))))
            return unusable;
        return std::unique_ptr<LandmarkModel>(std::move(model));
    } catch (const std::exception&) {
        return unusable;
    }
}

LbfModel::LbfModel(cv::Ptr<cv::face::FacemarkLBF> facemark, std::vector<Vec2> mean)
    : facemark_(std::move(facemark)), mean_(std::move(mean)) {}

/// The 68 points that the facemark places where the mean shape lies by `from_mean`, px of the picture.
std::optional<Points> LbfModel::look(const cv::Mat& picture, const Affine& from_mean) {
    const Vec2 across = from_mean.linear[0]; // half a box
    const CropFrame frame{from_mean.offset, 4.0 * length(across), std::atan2(across.y, across.x)};
    if (!is_sane(frame, picture))
        return std::nullopt;
    const Crop crop = take_crop(picture, frame, window_px);
    const std::vector<cv::Rect> box{{box_px / 2, box_px / 2, box_px, box_px}};
    std::vector<std::vector<cv::Point2f>> placed;
    if (!facemark_->fit(crop.pixels, box, placed) || placed.size() != 1 || placed[0].size() != mean_.size())
        return std::nullopt;
    Points points;
    for (const cv::Point2f p : placed[0]) {
        points.push_back(crop.to_picture(Vec2(p.x, p.y) + 0.5)); // OpenCV counts from the middle of a pixel
        if (!is_finite(points.back()))
            return std::nullopt;
    }
    return points;
}

std::optional<Landmarks> LbfModel::locate(const cv::Mat& picture, const Detection& face) {
    const auto coarse = look(picture, by_eyes(mean_, face));
    if (!coarse)
        return std::nullopt;
    const auto fine = look(picture, best_fit(mean_, *coarse));
    if (!fine)
        return std::nullopt;
    Landmarks found = features_of_68(*fine);
    const Landmarks before = features_of_68(*coarse);
    found.between_passes_px = {
        moved_px(before.right_eye, found.right_eye), moved_px(before.left_eye, found.left_eye),
        moved_px(before.outer_lip, found.outer_lip), moved_px(before.inner_lip, found.inner_lip),
        moved_px(before.outline, found.outline)};
    const auto judged = judge_.locate(picture, face);
    if (!judged)
        return std::nullopt;
    found.confidence =
        std::min(judged->confidence, confidence_of(found, {disagreement(*coarse, *fine), 0.0, 0.0}));
    return found;
}

} // namespace tp
