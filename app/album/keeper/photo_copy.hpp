// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <filesystem>

namespace tp {

/// Where a photograph came to lie.
struct CopiedPhoto {
    std::filesystem::path place;
    bool was_there = false; ///< with the same bytes: nothing was copied
};

/// Copies a photograph and all that is its own into a folder, the photograph last; under another number where
/// its name is taken. What a try that was cut off brought is used. An error is the end of a sentence.
Result<CopiedPhoto> copy_photo(const std::filesystem::path& photo, const std::filesystem::path& folder);

} // namespace tp
