// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/plugged_device.hpp"

#include <vector>

namespace tp {

/// Each board that is found, twice, as a 2diy of either generation, since nothing tells one from the other.
std::vector<PluggedDevice> plugged_boards();

} // namespace tp
