// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "faces/base/face.hpp"

#include <string>
#include <vector>

namespace tp {

/// Whose the faces of an extraction are, by the face regions of the photograph's metadata: one name for each, empty
/// where nobody said. A region that somebody marked belongs to the face that it overlaps most, if at least half of the
/// smaller of the two lies in the other; each region and each face once.
std::vector<std::string> names_of_faces(const Extraction& extraction, const PhotoRecord& record);

} // namespace tp
