// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/hid_pid/joystick_scale.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace tp {

constexpr double least_joystick_newtons =
    0.5; ///< of the whole force; what is beyond either counts as no measure
constexpr double greatest_joystick_newtons = 200.0;

/// What was measured of a stick, in a text of lines of "newtons_at_full sign_x sign_y key" after one that
/// says what this is; the key is the stick's serial number, or its product where it has none. A line that
/// makes no sense counts as none; of several the last one counts.
std::optional<JoystickScale> joystick_scale_in(std::string_view text, std::string_view key);

/// The same of a file; what is assumed of a stick that was not measured where there is none.
JoystickScale kept_joystick_scale(const std::filesystem::path& file, std::string_view key);

/// Adds it to the file, or puts it in the place of what was measured before; other lines stay as they are.
/// The sentence that says why not, else empty.
std::string keep_joystick_scale(const std::filesystem::path& file, const std::string& key,
                                const JoystickScale& scale);

/// touchphoto/sticks.txt in the person's folder for settings; empty where the environment names no such
/// folder.
std::filesystem::path joystick_scale_file();

} // namespace tp
