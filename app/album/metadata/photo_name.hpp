// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace tp {

/// Whether a file's name says that it is a photograph: by one of the `photo_endings`, in capitals or not.
/// Hidden files, such as those that other systems leave on a card, are none.
bool has_photo_name(const std::filesystem::path& file);

} // namespace tp
