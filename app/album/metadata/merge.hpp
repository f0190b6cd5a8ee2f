// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/record_parts.hpp"
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

/// Adds to `current` what only `other` has of what other programs wrote, and unites their lists of tags.
/// Tells which of their entries differ.
std::vector<std::string> add_foreign(XmpPacket& current, const XmpPacket& other);

} // namespace tp
