// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "faces/face.hpp"

#include <string>
#include <vector>

namespace tp {

/// Who the faces of an extraction are, by the face regions of the photograph's metadata: one name a face, empty
/// where nobody marked one there.
std::vector<std::string> names_at_faces(const Extraction& extraction, const PhotoRecord& record);

} // namespace tp
