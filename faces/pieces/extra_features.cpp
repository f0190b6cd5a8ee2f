// SPDX-License-Identifier: Apache-2.0
#include "faces/pieces/extra_features.hpp"

#include "faces/base/face.hpp"
#include "faces/pieces/fewest_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tp {
namespace {

constexpr std::size_t iris_points = 40;
/// Of an iris's height, below which what the lids leave of it is no shape to feel.
constexpr double least_visible = 0.25;

/// u along an eye from corner to corner, v across it; px.
struct EyeFrame {
    Vec2 origin, along;

    explicit EyeFrame(const Opening& eye)
        : origin(eye.lower.front()), along((eye.lower.back() - origin) / length(eye.lower.back() - origin)) {}
    Vec2 of(Vec2 p) const { return {glm::dot(p - origin, along), glm::dot(p - origin, across())}; }
    Vec2 back(Vec2 uv) const { return origin + uv.x * along + uv.y * across(); }
    Vec2 across() const { return {-along.y, along.x}; }
};

/// The height v of a lid at u; the lid runs towards larger u, but for small folds.
double height_at(const std::vector<Vec2>& lid, double u) {
    for (std::size_t i = 1; i < lid.size(); ++i)
        if (u <= lid[i].x && lid[i].x > lid[i - 1].x) {
            const double t = std::clamp((u - lid[i - 1].x) / (lid[i].x - lid[i - 1].x), 0.0, 1.0);
            return lid[i - 1].y + t * (lid[i].y - lid[i - 1].y);
        }
    return lid.back().y;
}

/// The circle, with what the lids hide moved onto the lids.
std::vector<Vec2> visible(const Iris& iris, const Opening& eye) {
    if (!(length(eye.lower.back() - eye.lower.front()) > 0.0) || !(iris.radius > 0.0))
        return {};
    const EyeFrame frame(eye);
    std::vector<Vec2> lower, upper;
    for (Vec2 p : eye.lower)
        lower.push_back(frame.of(p));
    for (Vec2 p : eye.upper)
        upper.push_back(frame.of(p));
    const Vec2 centre = frame.of(iris.centre);
    std::vector<Vec2> points;
    double least = centre.y + iris.radius, most = centre.y - iris.radius;
    for (std::size_t i = 0; i < iris_points; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / iris_points;
        const double u = centre.x + iris.radius * std::cos(angle);
        const auto [low, high] = std::minmax({height_at(lower, u), height_at(upper, u)});
        const double v = std::clamp(centre.y + iris.radius * std::sin(angle), low, high);
        least = std::min(least, v);
        most = std::max(most, v);
        points.push_back(frame.back({u, v}));
    }
    if (most - least < least_visible * 2.0 * iris.radius)
        return {};
    return points;
}

} // namespace

std::vector<Contour> extra_contours(const Landmarks& landmarks, const FaceLines& lines, double tolerance) {
    std::vector<Contour> contours;
    const auto add = [&](const char* name, const std::vector<Vec2>& points, bool closed) {
        if (!points.empty())
            contours.push_back(fewest_pieces(name, points, closed, {}, tolerance));
    };
    add(feature::left_brow, landmarks.left_brow, true);
    add(feature::right_brow, landmarks.right_brow, true);
    add(feature::nose, landmarks.nose, false);
    add(feature::left_iris, visible(landmarks.left_iris, lines.left_eye), true);
    add(feature::right_iris, visible(landmarks.right_iris, lines.right_eye), true);
    return contours;
}

} // namespace tp
