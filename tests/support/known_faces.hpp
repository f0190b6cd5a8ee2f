// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/seen_photos.hpp"
#include "app/album/open/open_album.hpp"

#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace tp::testing {

/// The numbers of one of many faces of a person: those of one person are some 0.2 apart, those of two 1.
inline std::string numbers_of(int person, unsigned face) {
    std::mt19937 who(static_cast<unsigned>(person)), which(1000U * static_cast<unsigned>(person) + face);
    std::string numbers(128, '\0');
    for (char& number : numbers)
        number = static_cast<char>(static_cast<int>(who() % 21U) - 10 + static_cast<int>(which() % 5U) - 2);
    return numbers;
}

/// Where the face at that place, from the left, lies on a photograph that `look_at` has looked at.
inline Rect place_of_face(std::size_t place) {
    const double left = 0.05 + 0.3 * static_cast<double>(place);
    return {Vec2(left, 0.2), Vec2(left + 0.2, 0.4)};
}

/// As if somebody had looked at the photograph and seen these people on it, side by side. Empty, or what went wrong.
inline std::string look_at(OpenAlbum& album, const std::filesystem::path& photo,
                           const std::vector<int>& people) {
    static unsigned next_face = 0;
    Looked looked;
    looked.seen.width = looked.seen.height = 100;
    for (const int person : people) {
        SeenFace face;
        face.part = place_of_face(looked.seen.faces.size());
        looked.seen.faces.push_back(face);
        looked.marks.push_back({NoGuess::none, numbers_of(person, next_face++)});
    }
    AlbumQueries queries = album.queries();
    const auto entry = queries.find(photo);
    const auto summary = entry && *entry ? queries.summary((*entry)->id)
                                         : Result<std::optional<PhotoSummary>>(Error{"not there"});
    if (!summary || !*summary)
        return "no such photograph: " + photo.string();
    return SeenPhotos(album.index(), 1, true).put((*summary)->sha256, looked);
}

} // namespace tp::testing
