// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/plugged_device.hpp"

#include <vector>

namespace tp {

/// The force-feedback sticks that are plugged in now. The caller holds bus_mutex().
std::vector<PluggedDevice> plugged_joysticks();

} // namespace tp
