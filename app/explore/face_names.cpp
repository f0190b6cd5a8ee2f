// SPDX-License-Identifier: Apache-2.0
#include "app/explore/face_names.hpp"

#include <algorithm>
#include <utility>

namespace tp {

namespace {

/// Of 0 … 1 in a picture, y down.
Vec2 upright(Vec2 p, int orientation) {
    switch (orientation) { // what EXIF 2.32, 4.6.4 says of row 0 and column 0
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

Vec2 turned_clockwise(Vec2 p, int degrees) {
    switch (degrees) {
    case 90:
        return {1.0 - p.y, p.x};
    case 180:
        return {1.0 - p.x, 1.0 - p.y};
    case 270:
        return {p.y, 1.0 - p.x};
    default:
        return p;
    }
}

double area(const Rect& box) { return std::max(0.0, box.width()) * std::max(0.0, box.height()); }

/// 0 … 1: the share of the smaller one that lies in the other. A point counts wholly.
double overlap(const Rect& a, const Rect& b) {
    const double smaller = std::min(area(a), area(b));
    if (smaller <= 0.0)
        return a.contains(b.centre()) || b.contains(a.centre()) ? 1.0 : 0.0;
    return area({glm::max(a.min, b.min), glm::min(a.max, b.max)}) / smaller;
}

struct Pair {
    std::size_t face = 0, region = 0;
    double share = 0.0, apart = 0.0;
};

} // namespace

Rect region_in_picture(const FaceRegion& region, int orientation, const Extraction& extraction) {
    const Vec2 half(0.5 * region.width, 0.5 * region.height);
    const Vec2 centre(region.x, region.y);
    const auto place = [&](Vec2 p) {
        return turned_clockwise(upright(p, orientation), extraction.turned_degrees) *
               Vec2(extraction.width, extraction.height);
    };
    const Vec2 a = place(centre - half);
    const Vec2 b = place(centre + half);
    return {glm::min(a, b), glm::max(a, b)};
}

std::vector<QString> names_of_faces(const Extraction& extraction, const PhotoRecord& record) {
    constexpr double enough = 0.5;
    std::vector<Pair> pairs;
    for (std::size_t region = 0; region < record.faces.size(); ++region) {
        const Rect marked = region_in_picture(record.faces[region], record.orientation, extraction);
        for (std::size_t face = 0; face < extraction.faces.size(); ++face) {
            const Rect& found = extraction.faces[face].box;
            if (const double share = overlap(marked, found); share >= enough)
                pairs.push_back({face, region, share, length(marked.centre() - found.centre())});
        }
    }
    std::ranges::stable_sort(pairs, [](const Pair& a, const Pair& b) {
        return a.share != b.share ? a.share > b.share : a.apart < b.apart;
    });
    std::vector<QString> names(extraction.faces.size());
    std::vector<bool> face_taken(extraction.faces.size(), false);
    std::vector<bool> region_taken(record.faces.size(), false);
    for (const Pair& pair : pairs)
        if (!face_taken[pair.face] && !region_taken[pair.region]) {
            face_taken[pair.face] = region_taken[pair.region] = true;
            names[pair.face] = QString::fromStdString(record.faces[pair.region].name).simplified();
        }
    return names;
}

} // namespace tp
