// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/haply_2diy/found_boards.hpp"
#include "device/plugged_device.hpp"

#include <vector>

namespace tp {

/// Each board that is found, twice, as a 2diy of either generation, since nothing tells one from the other.
std::vector<PluggedDevice> plugged_boards();
/// Nothing on the line tells the generations apart: each of these boards as the one and the other.
std::vector<PluggedDevice> as_either_generation(const std::vector<FoundBoard>& boards);

} // namespace tp
