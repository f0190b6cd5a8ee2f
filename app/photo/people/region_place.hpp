// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "core/geometry/vec.hpp"

namespace tp {

/// How the picture in which faces were found lies to the stored one.
struct PictureTurn {
    int orientation = 1;    ///< EXIF, 1 … 8: from the stored picture to the upright one
    int turned_degrees = 0; ///< clockwise, from there to the one with the faces (Extraction::turned_degrees)
};

/// A region of the stored picture as a part (0 … 1, y down) of the picture in which faces were found.
Rect shown_part(const FaceRegion& region, const PictureTurn& turn);
/// Back: the stored picture's region for a part of that picture, cut off at its edges; without a name.
FaceRegion stored_region(const Rect& part, const PictureTurn& turn);

/// The share of the smaller one that lies in the other, 0 … 1; a point's is 1 where it lies in the other.
double overlap(const Rect& a, const Rect& b);

/// Whether the two are one face, as far as their places tell: detectors and photo programs draw the box of a face
/// tighter or wider.
bool same_face(const Rect& a, const Rect& b);

} // namespace tp
