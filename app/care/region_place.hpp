// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"

#include <QRectF>

namespace tp {

/// How the picture in which faces were found lies to the stored one.
struct PictureTurn {
    int orientation = 1;    ///< EXIF, 1 … 8: from the stored picture to the upright one
    int turned_degrees = 0; ///< clockwise, from there to the one with the faces (Extraction::turned_degrees)
};

/// A region of the stored picture as a part (0 … 1, y down) of the picture in which faces were found.
QRectF shown_part(const FaceRegion& region, const PictureTurn& turn);
/// Back: the stored picture's region for a part of that picture, cut off at its edges; without a name.
FaceRegion stored_region(const QRectF& part, const PictureTurn& turn);

/// Whether the two are one face, as far as their places tell: detectors and photo programs draw the box of a face
/// tighter or wider.
bool same_face(const QRectF& a, const QRectF& b);

} // namespace tp
