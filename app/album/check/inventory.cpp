// SPDX-License-Identifier: Apache-2.0
#include "app/album/check/inventory.hpp"

#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/foreign_folder.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// Whether a file lies in some album's own folder: in a trash, or in what is being imported.
bool is_kept_apart(const fs::path& below_album) {
    return std::any_of(below_album.begin(), below_album.end(), is_own_folder);
}

} // namespace

Inventory inventory_of(const fs::path& album) {
    const ForeignFolder held(album);
    Inventory found;
    std::vector<fs::path> to_do{album};
    while (!to_do.empty()) {
        const fs::path folder = std::move(to_do.back());
        to_do.pop_back();
        int error = 0;
        const std::vector<FolderEntry> entries = entries_of(folder, &error);
        if (error != 0)
            found.unread[folder] = error;
        for (const FolderEntry& entry : entries) {
            const fs::path file = folder / entry.name;
            const std::string& name = entry.name;
            const bool apart = is_kept_apart(file.lexically_relative(album));
            if (entry.link) {
                if (apart || !name.starts_with('.'))
                    found.links.push_back(file);
                if (!apart && has_photo_name(file) && photo_there(file)) // it may be looked at
                    found.photos.push_back(file);
            } else if (entry.facts.kind == FileFacts::Kind::folder) {
                if (name.starts_with('.') && !apart)
                    continue;
                to_do.push_back(file);
                if (name.ends_with(tags_end) && !apart)
                    found.tags.push_back(file);
            } else if (entry.facts.kind == FileFacts::Kind::other) {
                if (apart || !name.starts_with('.'))
                    found.no_files.push_back(file);
            } else if (is_temporary(file)) {
                found.temporaries.push_back(file);
            } else if (apart) {
                continue;
            } else if (has_photo_name(file)) {
                found.photos.push_back(file);
            } else if (name.ends_with(contours_end) || name.ends_with(xmp_end)) {
                found.others.push_back(file);
            }
        }
    }
    for (auto* list :
         {&found.photos, &found.temporaries, &found.tags, &found.others, &found.links, &found.no_files})
        std::sort(list->begin(), list->end());
    return found;
}

} // namespace tp
