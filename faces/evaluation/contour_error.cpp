// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/contour_error.hpp"

#include "core/geometry/flatten.hpp"

#include <algorithm>
#include <limits>

namespace tp {
namespace {

constexpr std::size_t samples = 60;

double mean_distance(const Polyline& from, const Polyline& to) {
    double sum = 0.0;
    const Polyline points = resampled(from, samples);
    for (Vec2 p : points.points)
        sum += distance_to(to, p);
    return sum / static_cast<double>(points.points.size());
}

Vec2 centre_of(const Polyline& line) {
    Vec2 sum(0.0);
    const Polyline points = resampled(line, samples);
    for (Vec2 p : points.points)
        sum += p;
    return sum / static_cast<double>(points.points.size());
}

} // namespace

const Contour* contour_named(const std::vector<Contour>& contours, std::string_view name) {
    const auto found =
        std::find_if(contours.begin(), contours.end(), [&](const Contour& c) { return c.name == name; });
    return found == contours.end() ? nullptr : &*found;
}

double outer_inter_ocular_distance(const std::vector<Contour>& contours) {
    const Contour* right = contour_named(contours, feature::right_eye);
    const Contour* left = contour_named(contours, feature::left_eye);
    if (!right || !left)
        return 0.0;
    const Polyline right_line = flatten(*right), left_line = flatten(*left);
    if (right_line.points.empty() || left_line.points.empty())
        return 0.0;
    const Vec2 between = centre_of(left_line) - centre_of(right_line);
    if (!(length(between) > 0.0))
        return 0.0;
    const Vec2 along = between / length(between);
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for (Vec2 p : right_line.points)
        first = std::min(first, glm::dot(p, along));
    for (Vec2 p : left_line.points)
        last = std::max(last, glm::dot(p, along));
    return last - first;
}

std::optional<double> contour_error_percent(const std::vector<Contour>& truth,
                                            const std::vector<Contour>& found, std::string_view name) {
    const Contour* wanted = contour_named(truth, name);
    const Contour* given = contour_named(found, name);
    const double scale = outer_inter_ocular_distance(truth);
    if (!wanted || !given || !(scale > 0.0))
        return std::nullopt;
    const Polyline wanted_line = flatten(*wanted), given_line = flatten(*given);
    if (wanted_line.points.empty() || given_line.points.empty())
        return std::nullopt;
    double distance = mean_distance(wanted_line, given_line);
    if (name != feature::outline)
        distance = 0.5 * (distance + mean_distance(given_line, wanted_line));
    return 100.0 * distance / scale;
}

} // namespace tp
