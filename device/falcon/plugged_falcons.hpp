// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/plugged_device.hpp"

#include <vector>

namespace tp {

/// Falcons that are plugged in now, for the registry. Whoever calls holds bus_mutex().
std::vector<PluggedDevice> plugged_falcons();

} // namespace tp
