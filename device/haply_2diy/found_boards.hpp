// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// A serial port of an Arduino board, which a 2diy's board is too; what it really is only its answer tells.
struct FoundBoard {
    std::string path;          ///< of the port
    std::string serial_number; ///< empty where the system tells none
};

/// Those that are plugged in now. None on macOS.
std::vector<FoundBoard> find_boards();

/// Those that a Linux kernel shows below `ttys`.
std::vector<FoundBoard> find_boards_below(const std::filesystem::path& ttys,
                                          const std::filesystem::path& ports);

/// Whether a USB vendor's number, four hexadecimal digits, is Arduino's: 2341, or 2A03 of the other Arduino.
bool is_arduino(std::string_view vendor);

/// Arduino's vendor in what Windows calls a device ("USB\VID_2341&PID_003E\7523031393535120A0D1")?
bool is_arduino_instance(std::string_view instance);

/// The serial number in such a name; empty where Windows made one up, because the device has none or the port
/// is only a part of it.
std::string serial_number_in(std::string_view instance);

} // namespace tp
