// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/plugged_device.hpp"

#include <vector>

namespace tp {

/// The force pads that are plugged in now, each once: used over HID, and over its bulk interface where HID
/// does not show it or does not let it be opened. The caller holds bus_mutex().
std::vector<PluggedDevice> plugged_pads();

} // namespace tp
