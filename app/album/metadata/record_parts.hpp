// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tp {

/// What one source, a sidecar or the photograph, says; none: it says nothing of it, and the next source is
/// asked. Empty and there: it says that there is nothing.
struct RecordParts {
    std::optional<std::string> taken;
    std::optional<Place> place;
    std::optional<std::string> place_name;
    std::optional<LanguageTexts> alt_text;
    std::optional<LanguageTexts> description;
    std::optional<std::vector<FaceRegion>> faces;
    std::optional<std::vector<std::string>> persons;
    std::optional<std::vector<std::string>> keywords;
    std::optional<std::vector<Tag>> tags;
    std::optional<std::string> content_hash;
    std::vector<std::string> problems; ///< sentences

    bool operator==(const RecordParts&) const = default;
};

/// Takes from `lower` what `parts` does not say, and its problems.
void complete(RecordParts& parts, RecordParts lower);

} // namespace tp
