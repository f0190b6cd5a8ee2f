// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tp::hid {

/// What the device behind a hidraw node says of its reports: Linux's copy in /sys, which everyone may read, also before anybody
/// has the permission to open the device. Longer than most_descriptor_bytes where it is too long to be parsed; empty where it
/// cannot be read, and on other systems.
std::vector<std::uint8_t> hidraw_descriptor(const std::string& path);

} // namespace tp::hid
