// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/face_regions.hpp"
#include "app/album/metadata/record_parts.hpp"
#include "app/album/metadata/xmp_packet.hpp"

#include <string>
#include <vector>

namespace tp {

/// What a packet, a sidecar's or a photograph's own, says of the photograph.
RecordParts parts_from_xmp(const XmpPacket& packet, const PictureShape& shape);

/// The record that all sources together make.
PhotoRecord record_of(RecordParts parts, const PictureShape& shape);

/// The texts of a list, or the one text where there is no list; empty ones and repetitions left out.
std::vector<std::string> texts_of(const XmpValue& value);

} // namespace tp
