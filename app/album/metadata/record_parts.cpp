// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/record_parts.hpp"

#include <iterator>
#include <utility>

namespace tp {

namespace {

template <typename T>
void take(std::optional<T>& part, std::optional<T>& lower) {
    if (!part)
        part = std::move(lower);
}

} // namespace

void complete(RecordParts& parts, RecordParts lower) {
    take(parts.taken, lower.taken);
    take(parts.place, lower.place);
    take(parts.place_name, lower.place_name);
    take(parts.alt_text, lower.alt_text);
    take(parts.description, lower.description);
    take(parts.faces, lower.faces);
    take(parts.persons, lower.persons);
    take(parts.keywords, lower.keywords);
    take(parts.tags, lower.tags);
    take(parts.content_hash, lower.content_hash);
    std::move(lower.problems.begin(), lower.problems.end(), std::back_inserter(parts.problems));
}

} // namespace tp
