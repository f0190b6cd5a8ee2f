// SPDX-License-Identifier: Apache-2.0
#include "app/photo/people/face_names.hpp"

#include "app/photo/people/region_place.hpp"

#include <algorithm>
#include <cstddef>

namespace tp {

namespace {

struct Pair {
    std::size_t face = 0, region = 0;
    double share = 0.0, apart = 0.0;
};

/// Pixels of the picture in which the faces were found.
Rect pixels(const FaceRegion& region, const PhotoRecord& record, const Extraction& extraction) {
    const Rect part = shown_part(region, {record.orientation, extraction.turned_degrees});
    const Vec2 size(extraction.width, extraction.height);
    return {part.min * size, part.max * size};
}

} // namespace

std::vector<std::string> names_of_faces(const Extraction& extraction, const PhotoRecord& record) {
    constexpr double enough = 0.5;
    std::vector<Pair> pairs;
    for (std::size_t region = 0; region < record.faces.size(); ++region) {
        const Rect marked = pixels(record.faces[region], record, extraction);
        for (std::size_t face = 0; face < extraction.faces.size(); ++face) {
            const Rect& found = extraction.faces[face].box;
            if (const double share = overlap(marked, found); share >= enough)
                pairs.push_back({face, region, share, length(marked.centre() - found.centre())});
        }
    }
    std::ranges::stable_sort(pairs, [](const Pair& a, const Pair& b) {
        return a.share != b.share ? a.share > b.share : a.apart < b.apart;
    });
    std::vector<std::string> names(extraction.faces.size());
    std::vector<bool> face_taken(extraction.faces.size(), false);
    std::vector<bool> region_taken(record.faces.size(), false);
    for (const Pair& pair : pairs)
        if (!face_taken[pair.face] && !region_taken[pair.region]) {
            face_taken[pair.face] = region_taken[pair.region] = true;
            names[pair.face] = record.faces[pair.region].name;
        }
    return names;
}

} // namespace tp
