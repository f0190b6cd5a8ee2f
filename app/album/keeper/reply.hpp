// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/keeper/photo_files.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tp {

class AlbumKeeper;

/// What another copy of a photograph brought to the one in the album.
struct Reply {
    std::vector<std::string> recordings; ///< their file names among the photograph's
    bool words = false;            ///< names, descriptions, keywords, or what a recording says of itself
    std::vector<std::string> told; ///< sentences: where both differ, and what could not be brought

    bool empty() const { return recordings.empty() && !words; }
};

/// Brings to a photograph in the album what lies beside another copy of it, with the same bytes: recordings that it does
/// not have and that nobody threw away here, and what the sidecars say. What is there stays as it is; where both differ,
/// that is told. What a try that was cut off brought is not brought again. `other` and what is beside it are only read.
Reply take_reply(AlbumKeeper& keeper, const std::filesystem::path& photo, const std::filesystem::path& other,
                 const std::vector<Companion>& beside_other);

} // namespace tp
