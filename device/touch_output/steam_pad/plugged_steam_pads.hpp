// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/plugged_touch_output.hpp"

#include <vector>

namespace tp {

/// The controllers with Steam pads that are there now, a receiver once. The caller holds bus_mutex().
std::vector<PluggedTouchOutput> plugged_steam_pads();

} // namespace tp
