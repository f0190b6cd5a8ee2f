// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/face_regions.hpp"
#include "app/album/metadata/record_parts.hpp"
#include "app/album/metadata/write_sidecar.hpp"
#include "app/album/metadata/xmp_packet.hpp"

#include <string>
#include <vector>

namespace tp {

/// What stands behind a sidecar: the sources that are asked for what it does not say, most telling first.
struct Behind {
    std::vector<const XmpPacket*> packets;
    RecordParts parts; ///< of all of them, and of the photograph's EXIF and IPTC
    PictureShape shape;
};

/// Why these changes cannot be written, a sentence; empty where they can.
std::string refusal(const SidecarChanges& changes);

/// Makes the changes in a sidecar's packet. Lists that other programs keep too start from what stands behind
/// the sidecar, because those programs read the sidecar's list in place of the photograph's.
void edit(XmpPacket& sidecar, const SidecarChanges& changes, const Behind& behind);

} // namespace tp
