// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/folder_listing.hpp"
#include "app/album/index/sql_connection.hpp"
#include "app/album/metadata/photo_record.hpp"

#include <filesystem>
#include <optional>

namespace tp {

// Writes to the index, each inside a transaction of the caller's; all throw SqlFault.

/// What a scan found out about one photograph.
struct PhotoFacts {
    std::filesystem::path folder; ///< absolute, without symbolic links
    ListedPhoto listed;
    std::string sha256; ///< 32 bytes; empty: it cannot be read
    PhotoRecord record;
};

/// Puts the photograph in, or replaces what was known of it.
void put_photo(SqlConnection& connection, const PhotoFacts& facts);

/// Keeps the path and the content's hash of a photograph that is gone, and drops what it showed and told.
void miss_photo(SqlConnection& connection, std::int64_t id);

/// Drops a photograph.
void forget_photo(SqlConnection& connection, std::int64_t id);
/// Of content that is at no place any more, the faces are not known again.
void forget_faces_of_missing(SqlConnection& connection);

/// Says that the folder is there and looked like that.
void put_folder(SqlConnection& connection, const std::filesystem::path& folder, const std::string& stamp);

/// What the index says of a photograph; none where it is not in it.
std::optional<PhotoRecord> stored_record(SqlConnection& connection, std::int64_t id);

} // namespace tp
