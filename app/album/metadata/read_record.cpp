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

Result<RecordParts> parts_in(const fs::path& sidecar, const PictureShape& shape) {
    const auto bytes = read_whole(sidecar, XmpPacket::most_bytes);
    if (!bytes)
        return Error{bytes.error()};
    const auto packet = XmpPacket::from(*bytes);
    if (!packet)
        return Error{"The sidecar " + quoted(sidecar) + " cannot be read: " + packet.error()};
    return parts_from_xmp(*packet, shape);
}

RecordParts parts_from_sidecar(const fs::path& sidecar, const PictureShape& shape) {
    auto parts = parts_in(sidecar, shape);
    if (parts)
        return *std::move(parts);
    RecordParts nothing;
    nothing.problems.push_back(parts.error());
    return nothing;
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

Result<std::string> content_hash_in(const fs::path& sidecar) {
    const auto parts = parts_in(sidecar, {});
    return parts ? Result<std::string>(parts->content_hash.value_or(std::string{})) : Error{parts.error()};
}

} // namespace tp
