// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "faces/base/face.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace tp {

/// Whose faces are, by the face regions of a photograph's metadata.
struct NamedParts {
    std::vector<std::string> names;           ///< one for each face, empty where nobody said
    std::vector<std::size_t> regions_without; ///< regions that lie on none of them
};

/// A region that somebody marked belongs to the face that it overlaps most, if at least half of the smaller of the two
/// lies in the other; each region and each face once. `faces`: 0 … 1 of the picture that is shown, y down;
/// `turned_degrees` as in Extraction.
NamedParts names_of_parts(const std::vector<Rect>& faces, int turned_degrees, const PhotoRecord& record);

/// The names of an extraction's faces in that way.
std::vector<std::string> names_of_faces(const Extraction& extraction, const PhotoRecord& record);

} // namespace tp
