// SPDX-License-Identifier: Apache-2.0
#include "app/album/check/inventory.hpp"

#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/photo_name.hpp"
#include "core/files/new_file.hpp"

#include <algorithm>
#include <string>
#include <system_error>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// Whether a file lies in some album's own folder: in a trash, or in what is being imported.
bool is_kept_apart(const fs::path& below_album) {
    return std::any_of(below_album.begin(), below_album.end(), is_own_folder);
}

} // namespace

Inventory inventory_of(const fs::path& album) {
    Inventory found;
    std::error_code error;
    for (fs::recursive_directory_iterator place(album, fs::directory_options::skip_permission_denied, error),
         end;
         !error && place != end; place.increment(error)) {
        const fs::path file = place->path();
        const std::string name = file.filename().string();
        const bool apart = is_kept_apart(file.lexically_relative(album));
        if (place->is_directory(error)) {
            if (name.starts_with('.') && !apart)
                place.disable_recursion_pending();
            else if (name.ends_with(tags_end) && !apart)
                found.tags.push_back(file);
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
    for (auto* list : {&found.photos, &found.temporaries, &found.tags, &found.others})
        std::sort(list->begin(), list->end());
    return found;
}

} // namespace tp
