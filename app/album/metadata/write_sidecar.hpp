// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// Which fields of a sidecar become what; the others stay as they are. An empty value is a statement too: it
/// hides what the photograph itself says.
struct SidecarChanges {
    std::optional<LanguageTexts> alt_text;
    std::optional<LanguageTexts> description;
    std::optional<std::vector<FaceRegion>> faces; ///< written with named ones first, else in this order
    std::optional<std::vector<std::string>> persons; ///< the names of faces are always among them
    std::optional<std::vector<std::string>> keywords;
    std::optional<std::vector<Tag>> tags;
    std::optional<std::string> content_hash;

    bool operator==(const SidecarChanges&) const = default;
};

/// Changes these fields in `IMG_1.jpg.xmp` and keeps everything else that any program wrote there. Where it is
/// missing it begins with the content of a Lightroom sidecar made for this very file, else anew. What a second
/// program writes meanwhile is kept and changed in turn. The names of faces also become `PersonInImage`,
/// `digiKam:TagsList` and `lr:hierarchicalSubject`. Empty when done, and then a power cut does not undo it; else
/// a sentence, and the sidecar is as it was. A sidecar that cannot be read is never overwritten: that is such a
/// sentence too. Texts lose what XML cannot hold (control characters, bytes that are not UTF-8). The photograph
/// is only read. Any thread.
std::string write_sidecar(const std::filesystem::path& photo, const SidecarChanges& changes);

} // namespace tp
