// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <vector>

namespace tp {

/// Where the photographs lie, and which there are.
struct Photographs {
    std::filesystem::path folder;
    std::vector<std::filesystem::path> files; ///< in the order of their names
};

/// Those in a folder and in the folders in it, hidden ones left out; of a photograph just itself. An error where there
/// is none.
Result<Photographs> photographs_in(const std::filesystem::path& place);

} // namespace tp
