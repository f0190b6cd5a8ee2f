// SPDX-License-Identifier: Apache-2.0
#include "faces/judge/hidden_jaw.hpp"

#include "faces/contours/net_points.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tp {
namespace {

constexpr std::size_t least_points = 33; ///< of an outline
// Places beside the outline and on the cheeks, fractions of the distance between the eyes' outer corners.
constexpr std::array<double, 3> inside{0.05, 0.08, 0.11};
constexpr double skin_spot = 0.03; ///< side of the square over which a colour is averaged
constexpr std::array<double, 3> down_the_cheek{0.35, 0.45, 0.55}; ///< from an eye to the mouth's corner
constexpr std::array<double, 3> across_the_cheek{-0.05, 0.0, 0.05};
// L*, and a* and b* together, from which a place is darker, or of another colour, than the cheeks.
constexpr double darker_chin = 12.0, darker_side = 25.0, other_chin = 8.0, other_side = 10.0;

#include "faces/judge/hidden_jaw_weights.inc"

constexpr PointRange chin{10, 23}, right_side{1, 8}, left_side{25, 32}; ///< of the outline's points

/// L*a*b* of an sRGB colour, blue first, 0 … 255 (CIE 15, IEC 61966-2-1, white D65). OpenCV's makes tables at
/// its first call, in a tenth of a second, which a single photograph would wait for.
cv::Vec3d lab_of(const cv::Vec3d& bgr) {
    std::array<double, 3> linear{}; // red, green, blue
    for (int c = 0; c < 3; ++c) {
        const double v = bgr[2 - c] / 255.0;
        linear[static_cast<std::size_t>(c)] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    }
    const auto [r, g, b] = linear;
    const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    const double x = f((0.412453 * r + 0.357580 * g + 0.180423 * b) / 0.950456),
                 y = f(0.212671 * r + 0.715160 * g + 0.072169 * b),
                 z = f((0.019334 * r + 0.119193 * g + 0.950227 * b) / 1.088754);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// Means over small squares, L*a*b*.
std::vector<cv::Vec3d> colours_at(const cv::Mat& picture, const std::vector<Vec2>& places, double side) {
    const auto index = [](double at, int end) {
        return static_cast<int>(std::clamp(std::floor(at), 0.0, end - 1.0));
    };
    std::vector<cv::Vec3d> colours;
    for (const Vec2 place : places) {
        cv::Vec3d sum(0.0, 0.0, 0.0);
        for (const double y : {-1.0, 0.0, 1.0})
            for (const double x : {-1.0, 0.0, 1.0})
                sum += picture.at<cv::Vec3b>(index(place.y + y * side / 3.0, picture.rows),
                                             index(place.x + x * side / 3.0, picture.cols));
        colours.push_back(lab_of(sum / 9.0));
    }
    return colours;
}

/// By channel.
cv::Vec3d median_of(const std::vector<cv::Vec3d>& colours) {
    cv::Vec3d result;
    for (int c = 0; c < 3; ++c) {
        std::vector<double> values;
        for (const cv::Vec3d& colour : colours)
            values.push_back(colour[c]);
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        result[c] = *middle;
    }
    return result;
}

Vec2 mean_of(const std::vector<Vec2>& points) {
    Vec2 sum(0.0);
    for (const Vec2 p : points)
        sum += p / static_cast<double>(points.size());
    return sum;
}

/// A place's colour less that of the cheeks.
struct Difference {
    double lightness, colour;
};

/// What some places of the outline have in common.
struct Part {
    double lightness = 0.0, colour = 0.0; ///< means
    double darker = 0.0, other = 0.0;     ///< shares
};

Part part_of(const std::vector<Difference>& differences, PointRange range, double darker, double other) {
    Part part;
    const double share = 1.0 / static_cast<double>(range.size());
    for (std::size_t i = range.begin; i < range.end; ++i) {
        part.lightness += share * differences[i].lightness;
        part.colour += share * differences[i].colour;
        part.darker += differences[i].lightness < -darker ? share : 0.0;
        part.other += differences[i].colour > other ? share : 0.0;
    }
    return part;
}

double evidence(const std::array<double, jaw_sign_count>& weights,
                const std::array<double, jaw_sign_count>& signs) {
    double sum = 0.0;
    for (std::size_t i = 0; i < jaw_sign_count; ++i)
        sum += weights[i] * signs[i];
    return sum;
}

} // namespace

std::array<double, jaw_sign_count> jaw_signs(const cv::Mat& picture, const Landmarks& face) {
    const Vec2 across = face.left_eye[0] - face.right_eye[0];
    const double unit = length(across);
    if (picture.empty() || !(unit > 0.0) || face.outline.size() < least_points)
        return {};
    std::vector<Vec2> cheeks;
    const Vec2 eyes[] = {mean_of(face.right_eye), mean_of(face.left_eye)};
    const Vec2 corners[] = {face.outer_lip[0], face.outer_lip[mouth_corner]};
    for (std::size_t side = 0; side < 2; ++side)
        for (const double down : down_the_cheek)
            for (const double aside : across_the_cheek)
                cheeks.push_back(eyes[side] + down * (corners[side] - eyes[side]) + aside * across);
    const cv::Vec3d skin = median_of(colours_at(picture, cheeks, skin_spot * unit));
    const Vec2 middle = 0.25 * (eyes[0] + eyes[1]) + 0.5 * mean_of(face.outer_lip);
    std::vector<Difference> differences;
    for (const Vec2 p : face.outline) {
        const Vec2 inwards = (middle - p) / std::max(length(middle - p), 1e-9);
        std::vector<Vec2> places;
        for (const double reach : inside)
            places.push_back(p + reach * unit * inwards);
        const cv::Vec3d off = median_of(colours_at(picture, places, skin_spot * unit)) - skin;
        differences.push_back({off[0], std::hypot(off[1], off[2])});
    }
    const Part below = part_of(differences, chin, darker_chin, other_chin);
    const Part right = part_of(differences, right_side, darker_side, other_side);
    const Part left = part_of(differences, left_side, darker_side, other_side);
    return {1.0,
            below.lightness,
            below.colour,
            below.darker,
            below.other,
            std::min(right.lightness, left.lightness),
            std::max(right.colour, left.colour),
            std::max(right.darker, left.darker),
            std::max(right.other, left.other)};
}

JawCover jaw_cover(const std::array<double, jaw_sign_count>& signs) {
    if (evidence(beard_weights, signs) > 0.0)
        return JawCover::beard;
    return evidence(hair_weights, signs) > 0.0 ? JawCover::hair : JawCover::none;
}

} // namespace tp
