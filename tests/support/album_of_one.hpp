// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "album_parts.hpp"
#include "app/album/keeper/album_keeper.hpp"

namespace tp {

/// An album of one photograph that has one recording, by Anna.
struct AlbumOfOne {
    AlbumFolder folder;
    std::filesystem::path photo = a_photo(folder, "2026/IMG_1.jpg", 1);
    std::filesystem::path sound = a_sound(folder, "sounds/a.wav", 0.5, 300.0);
    AlbumKeeper keeper{folder.path()};
    std::string file =
        keeper.add_recording(photo, sound, {RecordingKind::memo, "Anna", {}, {}, {}, {}})->tag.file;
};

} // namespace tp
