// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/read_record.hpp"

#include "app/album/metadata/photo_metadata.hpp"
#include "app/album/metadata/sidecar_names.hpp"
#include "app/album/metadata/xmp_record.hpp"
#include "core/files/file_words.hpp"
#include "core/files/whole_file.hpp"

#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

RecordParts parts_from_sidecar(const fs::path& sidecar, const PictureShape& shape) {
    RecordParts parts;
    const auto bytes = read_whole(sidecar, XmpPacket::most_bytes);
    if (!bytes) {
        parts.problems.push_back(bytes.error());
        return parts;
    }
    const auto packet = XmpPacket::from(*bytes);
    if (!packet) {
        parts.problems.push_back("The sidecar " + quoted(sidecar) + " cannot be read: " + packet.error());
        return parts;
    }
    return parts_from_xmp(*packet, shape);
}

} // namespace

Result<PhotoRecord> read_record(const fs::path& photo) {
    auto metadata = photo_metadata(photo);
    if (!metadata)
        return Error{metadata.error()};
    RecordParts parts;
    for (const fs::path& sidecar : sidecars_of(photo))
        complete(parts, parts_from_sidecar(sidecar, metadata->shape));
    complete(parts, std::move(metadata->parts));

    return record_of(std::move(parts), metadata->shape);
}

} // namespace tp
