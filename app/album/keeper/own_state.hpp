// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace tp {

/// The person's own folder for what this program has to remember of its work: touchphoto in $XDG_STATE_HOME (default
/// ~/.local/state). What lies in an album may be somebody else's word, what lies here is
/// the program's own.
std::filesystem::path own_state_folder();

/// Where in it that is kept which concerns one album, by where the album lies; be it there or not.
std::filesystem::path own_state_of(const std::filesystem::path& album);

} // namespace tp
