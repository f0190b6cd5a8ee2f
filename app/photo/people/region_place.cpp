// SPDX-License-Identifier: Apache-2.0
#include "app/photo/people/region_place.hpp"

#include <algorithm>

namespace tp {

namespace {

/// Where a point of a picture goes by an EXIF orientation (CIPA DC-008, 4.6.4); 0 … 1, y down.
Vec2 oriented(Vec2 p, int orientation) {
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

int orientation_back(int orientation) { return orientation == 6 ? 8 : orientation == 8 ? 6 : orientation; }

int orientation_of(int turned_degrees) {
    return turned_degrees == 90 ? 6 : turned_degrees == 180 ? 3 : turned_degrees == 270 ? 8 : 1;
}

Rect oriented_part(const Rect& part, int orientation) {
    const Vec2 a = oriented(part.min, orientation);
    const Vec2 b = oriented(part.max, orientation);
    return {glm::min(a, b), glm::max(a, b)};
}

double area(const Rect& box) { return std::max(0.0, box.width()) * std::max(0.0, box.height()); }

/// Empty (min beyond max) where they share nothing.
Rect common(const Rect& a, const Rect& b) { return {glm::max(a.min, b.min), glm::min(a.max, b.max)}; }

} // namespace

Rect shown_part(const FaceRegion& region, const PictureTurn& turn) {
    const Vec2 centre(region.x, region.y);
    const Vec2 half(0.5 * region.width, 0.5 * region.height);
    return oriented_part(oriented_part({centre - half, centre + half}, turn.orientation),
                         orientation_of(turn.turned_degrees));
}

FaceRegion stored_region(const Rect& part, const PictureTurn& turn) {
    const Rect inside{glm::clamp(part.min, Vec2(0.0), Vec2(1.0)), glm::clamp(part.max, Vec2(0.0), Vec2(1.0))};
    const Rect stored = oriented_part(oriented_part(inside, orientation_back(orientation_of(turn.turned_degrees))),
                                      orientation_back(turn.orientation));
    return {stored.centre().x, stored.centre().y, stored.width(), stored.height(), {}};
}

double overlap(const Rect& a, const Rect& b) {
    const double smaller = std::min(area(a), area(b));
    if (smaller <= 0.0)
        return a.contains(b.centre()) || b.contains(a.centre()) ? 1.0 : 0.0;
    return area(common(a, b)) / smaller;
}

bool same_face(const Rect& a, const Rect& b) {
    const auto [smaller, larger] = std::minmax({area(a), area(b)});
    constexpr double much = 0.6;
    constexpr double alike = 1.0 / 6.0; // a head with hair has up to five times the area of its face
    return smaller > 0.0 && overlap(a, b) >= much && smaller >= alike * larger;
}

} // namespace tp
