// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/plugged_device.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tp {

/// A serial port of an Arduino board, which a 2diy's board is too; what it really is only its answer tells.
struct FoundBoard {
    std::string path; ///< of the port
    std::string serial_number;
};

/// Those that the kernel shows below `ttys` now: ports whose USB device has Arduino's vendor id (2341, or
/// 2A03 of the other Arduino).
std::vector<FoundBoard> find_boards(const std::filesystem::path& ttys = "/sys/class/tty",
                                    const std::filesystem::path& ports = "/dev");

/// Each of them twice, as a 2diy of either generation, since nothing tells one from the other.
std::vector<PluggedDevice> plugged_boards();

} // namespace tp
