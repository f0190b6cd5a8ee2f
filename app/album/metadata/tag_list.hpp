// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "app/album/metadata/xmp_value.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// Whether it names a file in a folder, and cannot lead out of it. Sidecars come from anywhere.
bool is_file_name(std::string_view name);

/// The recordings that `tp:tags` lists. Left out, with a sentence: what is no file name, and what is listed
/// twice. An unknown kind counts as a memo.
std::vector<Tag> tags_from(const XmpValue& list, std::vector<std::string>& problems);

/// `tp:tags` for these. Fields of `before` that this program does not know stay with their file.
XmpValue tag_list(const std::vector<Tag>& tags, const std::optional<XmpValue>& before);

} // namespace tp
