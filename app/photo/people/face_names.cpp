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

} // namespace

NamedParts names_of_parts(const std::vector<Rect>& faces, int turned_degrees, const PhotoRecord& record) {
    constexpr double enough = 0.5;
    std::vector<Pair> pairs;
    for (std::size_t region = 0; region < record.faces.size(); ++region) {
        const Rect marked = shown_part(record.faces[region], {record.orientation, turned_degrees});
        for (std::size_t face = 0; face < faces.size(); ++face)
            if (const double share = overlap(marked, faces[face]); share >= enough)
                pairs.push_back({face, region, share, length(marked.centre() - faces[face].centre())});
    }
    std::ranges::stable_sort(pairs, [](const Pair& a, const Pair& b) {
        return a.share != b.share ? a.share > b.share : a.apart < b.apart;
    });
    NamedParts named{std::vector<std::string>(faces.size()), {}};
    std::vector<bool> face_taken(faces.size(), false);
    std::vector<bool> region_taken(record.faces.size(), false);
    for (const Pair& pair : pairs)
        if (!face_taken[pair.face] && !region_taken[pair.region]) {
            face_taken[pair.face] = region_taken[pair.region] = true;
            named.names[pair.face] = record.faces[pair.region].name;
        }
    for (std::size_t region = 0; region < record.faces.size(); ++region)
        if (!region_taken[region])
            named.regions_without.push_back(region);
    return named;
}

std::vector<std::string> names_of_faces(const Extraction& extraction, const PhotoRecord& record) {
    const Vec2 size(std::max(extraction.width, 1), std::max(extraction.height, 1));
    std::vector<Rect> parts;
    for (const Face& face : extraction.faces)
        parts.push_back({face.box.min / size, face.box.max / size});
    return names_of_parts(parts, extraction.turned_degrees, record).names;
}

} // namespace tp
