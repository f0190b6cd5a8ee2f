// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/hid_pid/stick_scale.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace tp {

/// What was measured of a stick, in a text of lines of "newtons_at_full sign_x sign_y key" after one that
/// says what this is; the key is the stick's serial number, or its product where it has none. A line that
/// makes no sense counts as none; of several the last one counts.
std::optional<StickScale> stick_scale_in(std::string_view text, std::string_view key);

/// The same of a file; what is assumed of a stick that was not measured where there is none.
StickScale kept_stick_scale(const std::filesystem::path& file, std::string_view key);

/// touchphoto/sticks.txt in the person's folder for settings; empty where the environment names no such
/// folder.
std::filesystem::path stick_scale_file();

} // namespace tp
