// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/face_regions.hpp"
#include "app/album/metadata/record_parts.hpp"
#include "app/album/metadata/xmp_packet.hpp"
#include "core/base/result.hpp"

#include <filesystem>
#include <optional>

namespace tp {

/// What a photograph's own file says: EXIF, IPTC IIM and XMP.
struct PhotoMetadata {
    PictureShape shape;
    RecordParts parts; ///< EXIF before XMP before IPTC
    std::optional<XmpPacket> xmp;
};

/// An error only where there is no such file or it cannot be opened. No pixel is decoded, nothing is written.
Result<PhotoMetadata> photo_metadata(const std::filesystem::path& photo);

} // namespace tp
