// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/record_parts.hpp"
#include "app/album/metadata/sidecar_edit.hpp"
#include "app/album/metadata/write_sidecar.hpp"
#include "app/album/metadata/xmp_packet.hpp"

#include <string>
#include <vector>

namespace tp {

/// What two versions of one sidecar come to, and sentences about where they differed.
struct Merge {
    SidecarChanges changes; ///< from `current` to what holds both
    std::vector<std::string> told;
};

/// `other_is_newer` decides between two labels of one recording, and nothing else: the text that is there
/// stays. Nothing of `other` is lost: it is in the changes or told.
Merge merged(const RecordParts& current, const RecordParts& other, bool other_is_newer);

/// Of a sidecar that was displaced, what another program may have added since: the keywords. Faces, persons, tags and texts are left
/// out, because what displaced it may have taken them away.
RecordParts added_meanwhile(RecordParts parts);

/// Brings another packet into a sidecar: `parts` as `merged` does, what only `other` has of what other programs wrote, and
/// their lists of tags united. Tells where they differ.
std::vector<std::string> bring_in(XmpPacket& sidecar, const XmpPacket& other, const RecordParts& parts,
                                  bool other_is_newer, const Behind& behind);

} // namespace tp
