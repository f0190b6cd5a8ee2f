// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "app/album/metadata/xmp_value.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tp {

/// The photograph that regions lie in.
struct PictureShape {
    long long width = 0, height = 0; ///< px as stored; 0 where unknown
    int orientation = 1;             ///< EXIF, 1 … 8
};

/// The faces among the regions of `mwg-rs:Regions` (Metadata Working Group, Guidelines 2.0, 5.9). Regions
/// that a program made on the turned picture, told by their AppliedToDimensions, are turned back. What makes
/// no sense is left out, with a sentence.
std::vector<FaceRegion> faces_from_mwg(const XmpValue& regions, const PictureShape& shape,
                                       std::vector<std::string>& problems);

/// The same for `MP:RegionInfo`, whose rectangles begin at their upper left corner.
std::vector<FaceRegion> faces_from_microsoft(const XmpValue& info, std::vector<std::string>& problems);

/// `mwg-rs:Regions` for these faces, named ones first, because one widely used reader stops at the first
/// unnamed one. Of `before` it keeps regions that are no faces, and what other programs said of faces that
/// are still there.
XmpValue mwg_from_faces(const std::vector<FaceRegion>& faces, const std::optional<XmpValue>& before,
                        const PictureShape& shape);
XmpValue microsoft_from_faces(const std::vector<FaceRegion>& faces, const XmpValue& before);

} // namespace tp
