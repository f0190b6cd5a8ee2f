// SPDX-License-Identifier: Apache-2.0
#include "app/tactile/face_names.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace tp {

namespace {

/// A place in the stored picture, 0 … 1, as it is in the upright one (EXIF orientation 1 … 8).
Vec2 upright(Vec2 p, int orientation) {
    switch (orientation) {
    case 2:
        return {1.0 - p.x, p.y};
    case 3:
        return {1.0 - p.x, 1.0 - p.y};
    case 4:
        return {p.x, 1.0 - p.y};
    case 5:
        return {p.y, p.x};
    case 6:
        return {1.0 - p.y, p.x};
    case 7:
        return {1.0 - p.y, 1.0 - p.x};
    case 8:
        return {p.y, 1.0 - p.x};
    default:
        return p;
    }
}

/// The same after the extraction turned the picture clockwise.
Vec2 turned_clockwise(Vec2 p, int degrees) {
    return degrees == 90 ? Vec2(1.0 - p.y, p.x) : degrees == 180 ? Vec2(1.0) - p : degrees == 270 ? Vec2(p.y, 1.0 - p.x) : p;
}

} // namespace

std::vector<std::string> names_at_faces(const Extraction& extraction, const PhotoRecord& record) {
    std::vector<std::string> names(extraction.faces.size());
    for (const FaceRegion& region : record.faces) {
        const Vec2 centre = turned_clockwise(upright({region.x, region.y}, record.orientation), extraction.turned_degrees) *
                            Vec2(extraction.width, extraction.height);
        std::optional<std::size_t> nearest;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < extraction.faces.size(); ++i) {
            const Rect& box = extraction.faces[i].box;
            const double away = length(centre - box.centre());
            if (names[i].empty() && away < 0.5 * std::max(box.width(), box.height()) && away < least) {
                least = away;
                nearest = i;
            }
        }
        if (nearest)
            names[*nearest] = region.name;
    }
    return names;
}

} // namespace tp
