// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "faces/face.hpp"

#include <QString>

#include <vector>

namespace tp {

/// A region of the stored picture as pixels of the picture that faces were found in: upright by its EXIF
/// orientation, then turned clockwise by Extraction::turned_degrees.
Rect region_in_picture(const FaceRegion& region, int orientation, const Extraction& extraction);

/// Whose the faces are, one name for each; empty where nobody said. A region that somebody marked belongs to the face
/// that it overlaps most, if most of the smaller of the two lies in the other; each region and each face once.
std::vector<QString> names_of_faces(const Extraction& extraction, const PhotoRecord& record);

} // namespace tp
