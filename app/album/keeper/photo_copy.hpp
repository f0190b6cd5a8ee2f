// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/keeper/photo_files.hpp"
#include "core/base/result.hpp"

#include <filesystem>
#include <vector>

namespace tp {

/// Where a photograph came to lie.
struct CopiedPhoto {
    std::filesystem::path place;
    bool was_there = false; ///< with the same bytes: nothing was copied
};

/// Copies a photograph and its companions into a folder, the photograph last; under another number where
/// its name is taken. What a try that was cut off brought is used. An error is the end of a sentence.
Result<CopiedPhoto> copy_photo(const std::filesystem::path& photo, const std::vector<Companion>& companions,
                               const std::filesystem::path& folder);

} // namespace tp
