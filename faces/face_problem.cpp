// SPDX-License-Identifier: Apache-2.0
#include "faces/face_problem.hpp"

#include "core/geometry/polyline.hpp"

#include <cmath>

namespace tp {
namespace {

constexpr double smallest_exact_px = 32.0; ///< width of a face whose eyes still have some pixels
constexpr double most_outside = 0.03;      ///< of the face's width, that its contours may leave the picture

/// "left edge", "left and top edges", …; empty where the points stay inside.
std::string edges_crossed(const Rect& points, double tolerance, const cv::Size& picture) {
    std::string names;
    int count = 0;
    const auto add = [&](const char* name, double outside) {
        if (outside > tolerance)
            names += (count++ ? " and " : "") + std::string(name);
    };
    add("left", -points.min.x);
    add("right", points.max.x - picture.width);
    add("top", -points.min.y);
    add("bottom", points.max.y - picture.height);
    return names.empty() ? names : names + (count > 1 ? " edges" : " edge");
}

constexpr double worth_saying_percent = 3.0; ///< six times what lids, thrice what lips usually miss
constexpr const char* spoken[] = {"right eye", "left eye", "mouth", "mouth", "outline"}; // as FeatureIndex

} // namespace

std::string problem_of(const Detection& face, const Landmarks& points, const cv::Size& picture) {
    const double width = face.size();
    if (width < smallest_exact_px)
        return "The face is only " + std::to_string(std::lround(width)) +
               " pixels wide, too small for its contours to be exact.";
    std::vector<Vec2> all = points.outline;
    for (const auto* part : {&points.right_eye, &points.left_eye, &points.outer_lip})
        all.insert(all.end(), part->begin(), part->end());
    const std::string edges = edges_crossed(bounds_of(all), most_outside * width, picture);
    if (!edges.empty())
        return "The face is cut off at the " + edges + " of the picture.";
    return {};
}

std::string problem_of(const QualitySigns& signs) {
    double worst = worth_saying_percent;
    std::string sentence;
    for (std::size_t f = 0; f < feature_count; ++f) {
        const ContourQuality quality = quality_of(signs, static_cast<FeatureIndex>(f));
        if (quality.reasons.empty() || quality.expected_error_percent < worst)
            continue;
        worst = quality.expected_error_percent;
        const std::string& reason = quality.reasons.back();
        const std::string feature = spoken[f];
        if (reason == "may be covered")
            sentence = "The " + feature + " may be covered, so its contour may be wrong.";
        else if (reason == "its edge is faint")
            sentence = "The edge of the " + feature + " is faint, so its contour may be wrong.";
        else
            sentence = "The face is " + reason + ", so the contour of the " + feature + " may be wrong.";
    }
    return sentence;
}

} // namespace tp
