// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace tp {

/// A deleted recording as the trash remembers it, so that it comes back into its photograph's list as it was.
struct TagNote {
    std::filesystem::path photo; ///< relative to the album's folder
    Tag tag;
};
std::string note_of(const TagNote& tag);
/// None where the note is about something else.
std::optional<TagNote> tag_note(const std::string& note);

} // namespace tp
