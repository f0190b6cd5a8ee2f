// SPDX-License-Identifier: Apache-2.0
#include "app/photo/sight/face_sight.hpp"

#include "core/geometry/flatten.hpp"
#include "core/study/expression_cues.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace tp {

namespace {

const Contour* contour_named(const std::vector<Contour>& contours, const char* name) {
    const auto found = std::find_if(contours.begin(), contours.end(),
                                    [&](const Contour& contour) { return contour.name == name; });
    return found == contours.end() ? nullptr : &*found;
}

/// The expected error of a contour, percent; infinite where something covers it or nothing is known.
double error_of(const Face& face, const char* name) {
    for (std::size_t i = 0; i < face.contours.size() && i < face.quality.size(); ++i)
        if (face.contours[i].name == name) {
            const ContourQuality& quality = face.quality[i];
            return is_said_hidden(quality) ? std::numeric_limits<double>::infinity()
                                           : quality.expected_error_percent;
        }
    return std::numeric_limits<double>::infinity();
}

/// A line's extent along an axis and across it.
struct Extent {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    double below = low, above = -low;

    Extent(const Polyline& line, Vec2 axis) {
        const Vec2 across(-axis.y, axis.x);
        for (const Vec2 p : line.points) {
            low = std::min(low, glm::dot(p, axis));
            high = std::max(high, glm::dot(p, axis));
            below = std::min(below, glm::dot(p, across));
            above = std::max(above, glm::dot(p, across));
        }
    }
    double openness() const { return high > low ? (above - below) / (high - low) : 0.0; }
};

Vec2 mean_of(const Polyline& line) {
    Vec2 sum{0.0};
    for (const Vec2 p : line.points)
        sum += p;
    return sum / static_cast<double>(line.points.size());
}

/// Linear discriminant between 68 people's neutral and smiling portraits (Face Research Lab London Set, DeBruine and
/// Jones 2017) with a shared covariance.
double smile_log_odds(const FaceMeasures& measures) {
    return 0.281 * measures.mouth_width + 0.069 * measures.mouth_opening + 0.340 * measures.corner_lift -
           17.58;
}

double balance(double a, double b) {
    return std::clamp((a - b) / std::max(std::abs(a) + std::abs(b), 1e-9), -1.0, 1.0);
}

} // namespace

std::optional<FaceMeasures> measures_of(const Face& face) {
    const Result<ExpressionCues> cues = expression_cues(face.contours);
    const Contour* right = contour_named(face.contours, feature::right_eye);
    const Contour* left = contour_named(face.contours, feature::left_eye);
    const Contour* outline = contour_named(face.contours, feature::outline);
    if (!cues || right == nullptr || left == nullptr || outline == nullptr)
        return std::nullopt;
    const Polyline right_line = flatten(*right), left_line = flatten(*left), outline_line = flatten(*outline);
    const Vec2 across = mean_of(left_line) - mean_of(right_line);
    if (outline_line.points.size() < 2 || !(length(across) > 0.0))
        return std::nullopt;
    const Vec2 axis = across / length(across);
    const Extent right_eye(right_line, axis), left_eye(left_line, axis);

    FaceMeasures measures;
    measures.mouth_width = at(*cues, Cue::mouth_width);
    measures.mouth_opening = at(*cues, Cue::mouth_opening);
    measures.corner_lift = at(*cues, Cue::inner_corner_lift);
    measures.smile = smile_log_odds(measures);
    measures.eye_openness = std::max(right_eye.openness(), left_eye.openness());
    const double ends[2] = {glm::dot(outline_line.points.front(), axis),
                            glm::dot(outline_line.points.back(), axis)};
    measures.turn =
        balance(std::max(ends[0], ends[1]) - left_eye.high, right_eye.low - std::min(ends[0], ends[1]));
    constexpr double sure_percent = 2.5;
    measures.eyes_sure =
        error_of(face, feature::right_eye) < sure_percent && error_of(face, feature::left_eye) < sure_percent;
    measures.mouth_sure = error_of(face, feature::outer_lip) < sure_percent &&
                          error_of(face, feature::inner_lip) < sure_percent;
    return measures;
}

Mien mien_of(const FaceMeasures& measures) {
    // Grounds: the most that a neutral portrait reaches is 1.4; of photographs in the wild (../shared/faces/photos/wild)
    // with 0 to 2 every second smiles, from 3 on all that were looked at.
    constexpr double perhaps_from = 1.5, sure_from = 3.0, broad_from = 5.0;
    constexpr double teeth_from = 12.0,
                     laughing_from = 19.0; // a mouth's opening; a smile that shows teeth has up to 18
    constexpr double turned_from = 0.6;    // beyond, corners of a mouth are foreshortened
    if (!measures.mouth_sure || measures.smile < perhaps_from)
        return Mien::unknown;
    if (measures.smile < sure_from || std::abs(measures.turn) > turned_from)
        return Mien::perhaps_smiling;
    if (measures.smile < broad_from || measures.mouth_opening < teeth_from)
        return Mien::smiling;
    return measures.mouth_opening < laughing_from ? Mien::smiling_broadly : Mien::perhaps_laughing;
}

Eyes eyes_of(const FaceMeasures& measures) {
    // Eyes that laughter narrows are open by 0.17 and more; those that look down at a table by 0.1.
    constexpr double shut_below = 0.08, perhaps_below = 0.14, open_from = 0.2;
    if (!measures.eyes_sure)
        return Eyes::unknown;
    return measures.eye_openness < shut_below      ? Eyes::shut
           : measures.eye_openness < perhaps_below ? Eyes::perhaps_shut
           : measures.eye_openness < open_from     ? Eyes::unknown
                                                   : Eyes::open;
}

Facing facing_of(const FaceMeasures& measures) {
    constexpr double aside_from = 0.65, frontal_below = 0.3; // 26 degrees are 0.38 (faces/judge)
    if (std::abs(measures.turn) >= aside_from)
        return measures.turn > 0.0 ? Facing::left : Facing::right;
    return std::abs(measures.turn) < frontal_below ? Facing::camera : Facing::unknown;
}

} // namespace tp
