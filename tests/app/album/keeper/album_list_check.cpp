// SPDX-License-Identifier: Apache-2.0
#include "album_list_check.hpp"

#include "app/album/keeper/import_list.hpp"
#include "app/album/keeper/path_text.hpp"
#include "app/album/keeper/tag_note.hpp"
#include "app/album/keeper/trash.hpp"
#include "memory_folder.hpp"

#include <cstdlib>

namespace tp::test {

namespace {

std::string complaint_about_trash(const std::filesystem::path& album) {
    const auto entry = Trash(album).entry("1");
    if (!entry)
        return entry.error().ends_with('.') ? "" : "a deletion is refused without a sentence";
    if (entry->files.empty())
        return "a deletion of nothing";
    for (const auto& file : entry->files)
        if (!stays_below(file))
            return "a deleted file would come back elsewhere";
    return {};
}

std::string complaint_about_import(const std::filesystem::path& album) {
    const auto list = ImportList::read(album, "1");
    if (!list)
        return list.error().ends_with('.') ? "" : "an import is refused without a sentence";
    return list->makes_sense() ? "" : "an import that makes no sense";
}

std::string complaint_about_note(const std::string& text) {
    const auto note = tag_note(text);
    if (!note)
        return {};
    const auto again = tag_note(note_of(*note));
    return again && again->photo == note->photo && again->tag.file == note->tag.file
               ? ""
               : "a note that is another when it was written";
}

} // namespace

std::string complaint_about_album_lists(std::string_view bytes) {
    static const MemoryFolder album, state;
    ::setenv("XDG_STATE_HOME", state.path().c_str(), 1);
    album.file(".touchphoto/trash/1/list.json", bytes);
    state.file(ImportList::place_of(album.path(), "1").lexically_relative(state.path()), bytes);
    for (const std::string& complaint :
         {complaint_about_trash(album.path()), complaint_about_import(album.path()),
          complaint_about_note(std::string(bytes))})
        if (!complaint.empty())
            return complaint;
    return {};
}

} // namespace tp::test
