// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/plugged_touch_output.hpp"

#include <vector>

namespace tp {

/// feedbackd, where it has a motor; nothing where it has none or is not there. Any thread; it may wait half a second.
std::vector<PluggedTouchOutput> plugged_feedbackd();

} // namespace tp
