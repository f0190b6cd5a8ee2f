// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tp::falcon {

/// Where a person puts the firmware of their Falcon, which its licence keeps from being brought along:
/// touchphoto/falcon/firmware.bin in $XDG_DATA_HOME (default ~/.local/share).
std::filesystem::path firmware_file();

/// What is in the file; empty where there is none. An error where it cannot be read or is no firmware by its
/// size: those known have 7914 to 8492 bytes (libnifalcon at f7c727a).
Result<std::vector<std::uint8_t>> firmware_in(const std::filesystem::path& file);

} // namespace tp::falcon
