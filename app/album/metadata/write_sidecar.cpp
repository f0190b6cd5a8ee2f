// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/write_sidecar.hpp"

#include "app/album/metadata/change_sidecar.hpp"
#include "app/album/metadata/xmp_record.hpp"

#include <utility>

namespace tp {

std::string write_sidecar(const std::filesystem::path& photo, const SidecarChanges& changes) {
    return write_sidecar(photo, [&](const PhotoRecord&) { return changes; });
}

std::string write_sidecar(const std::filesystem::path& photo, const ChangesFrom& changes_from) {
    return change_sidecar(photo, [&](XmpPacket& sidecar, const Behind& behind) {
        RecordParts parts = parts_from_xmp(sidecar, behind.shape);
        complete(parts, behind.parts);
        const SidecarChanges changes = changes_from(record_of(std::move(parts), behind.shape));
        std::string refused = refusal(changes);
        if (refused.empty())
            edit(sidecar, changes, behind);
        return refused;
    });
}

} // namespace tp
