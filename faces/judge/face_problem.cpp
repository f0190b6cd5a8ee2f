// SPDX-License-Identifier: Apache-2.0
#include "faces/judge/face_problem.hpp"

#include "core/geometry/polyline.hpp"

#include <cmath>

namespace tp {
namespace {

constexpr double smallest_exact_px = 32.0; ///< width of a face whose eyes still have some pixels
constexpr double most_outside = 0.03;      ///< of the face's width, that its contours may leave the picture

/// By a bit for each of left, right, top, bottom; whole, because languages join them in their own ways.
constexpr const char* edge_names[] = {"",
                                      "left edge",
                                      "right edge",
                                      "left and right edges",
                                      "top edge",
                                      "left and top edges",
                                      "right and top edges",
                                      "left and right and top edges",
                                      "bottom edge",
                                      "left and bottom edges",
                                      "right and bottom edges",
                                      "left and right and bottom edges",
                                      "top and bottom edges",
                                      "left and top and bottom edges",
                                      "right and top and bottom edges",
                                      "left and right and top and bottom edges"};

/// "left edge", "left and top edges", …; empty where the points stay inside.
std::string edges_crossed(const Rect& points, double tolerance, const cv::Size& picture) {
    const unsigned crossed =
        (-points.min.x > tolerance ? 1U : 0U) | (points.max.x - picture.width > tolerance ? 2U : 0U) |
        (-points.min.y > tolerance ? 4U : 0U) | (points.max.y - picture.height > tolerance ? 8U : 0U);
    return edge_names[crossed];
}

constexpr double worth_saying_percent =
    3.0; ///< six times what lids, thrice what lips usually miss; a cover is always said
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
    double worst = 0.0;
    std::string sentence;
    for (std::size_t f = 0; f < feature_count; ++f) {
        const ContourQuality quality = quality_of(signs, static_cast<FeatureIndex>(f));
        if (quality.reasons.empty() || quality.expected_error_percent < worst)
            continue;
        const std::string& reason = quality.reasons.back();
        if (!is_said_hidden(quality) && quality.expected_error_percent < worth_saying_percent)
            continue;
        worst = quality.expected_error_percent;
        const std::string feature = spoken[f];
        if (reason == covered_reason)
            sentence = "The " + feature + " may be covered, so its contour may be wrong.";
        else if (reason == dark_glasses_reason)
            sentence = "Dark glasses hide the eyes, so their contours are a guess.";
        else if (reason == "a beard hides it")
            sentence = "A beard hides the jaw, so the outline may be wrong.";
        else if (reason == "hair hides it")
            sentence = "Hair hides the jaw, so the outline may be wrong.";
        else if (reason == "its edge is faint")
            sentence = "The edge of the " + feature + " is faint, so its contour may be wrong.";
        else
            sentence = "The face is " + reason + ", so the contour of the " + feature + " may be wrong.";
    }
    return sentence;
}

} // namespace tp
