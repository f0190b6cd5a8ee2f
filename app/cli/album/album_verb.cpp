// SPDX-License-Identifier: Apache-2.0
#include "app/cli/album/album_verbs.hpp"
#include "app/cli/album/album_words.hpp"
#include "app/cli/verbs.hpp"

#include <array>

namespace tp {

int album_verb(const QStringList& words) {
    static constexpr std::array<SubVerb, 11> verbs{{
        {"scan", "bring the index of an album up to date", album_scan},
        {"list", "the photographs of an album, by time, person or year", album_list},
        {"search", "photographs by what is known of them", album_search},
        {"show", "everything known of one photograph", album_show},
        {"import", "copy photographs into an album, with all that belongs to them", album_import},
        {"export", "write photographs with all that belongs to them as one .touchphoto file", album_export},
        {"tag", "recordings: add, list, label, order, trim, delete", album_tag},
        {"person", "people: list, rename, merge, name faces, record names", album_person},
        {"trash", "what was deleted: list, restore, empty", album_trash},
        {"check", "check that an album is whole, and mend it", album_check},
        {"rebuild", "rebuild the index", album_rebuild},
    }};
    return run_sub_verb("album", verbs, words);
}

} // namespace tp
