// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <filesystem>
#include <string>

namespace tp {

/// All bytes of a file of at most `most_bytes`. An error is a whole sentence with the file's name; pipes,
/// devices and folders are refused, because reading them may never end.
Result<std::string> read_whole(const std::filesystem::path& file, std::size_t most_bytes);

} // namespace tp
