// SPDX-License-Identifier: Apache-2.0
#include "app/explore/place_words.hpp"

#include "app/scene/feature_words.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace tp {

int clock_direction(Vec2 direction) {
    const double turns = std::atan2(direction.x, direction.y) / (2.0 * std::numbers::pi);
    const int hour = static_cast<int>(std::lround(12.0 * turns + 12.0)) % 12;
    return hour == 0 ? 12 : hour;
}

Vec2 landing_place(const Polyline& line) {
    return line.closed ? line.points.front() : point_along(line, 0.5 * length_of(line));
}

QString where_am_i(const FlatScene& scene, Vec2 finger, int feature) {
    const auto named = [&](std::size_t i) { return QString::fromStdString(spoken_feature(scene.names[i])); };
    if (feature >= 0)
        return "On the " + named(static_cast<std::size_t>(feature)) + ".";
    double nearest_mm = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < scene.lines.size(); ++i)
        if (const double distance = distance_to(scene.lines[i], finger); distance < nearest_mm) {
            nearest_mm = distance;
            nearest = i;
        }
    if (!std::isfinite(nearest_mm))
        return "There is nothing to feel here.";
    const Polyline& line = scene.lines[nearest];
    const Vec2 way = point_along(line, nearest_arc(line, finger)) - finger;
    return QString("The nearest line is the %1, at %2 o'clock, %3 millimetres away.")
        .arg(named(nearest))
        .arg(clock_direction(way))
        .arg(std::lround(nearest_mm));
}

} // namespace tp
