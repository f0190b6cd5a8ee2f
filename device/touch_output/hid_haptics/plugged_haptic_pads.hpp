// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/plugged_touch_output.hpp"

#include <vector>

namespace tp {

/// The devices with haptics by HID that are there now. The caller holds bus_mutex().
std::vector<PluggedTouchOutput> plugged_haptic_pads();

} // namespace tp
