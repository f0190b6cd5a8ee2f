// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/force_feedback/event_nodes.hpp"
#include "device/touch_output/plugged_touch_output.hpp"

#include <vector>

namespace tp {

/// Each device that plays effects, now.
std::vector<PluggedTouchOutput> plugged_feedback();

/// The same of those that were found; where two tell one serial number, the second goes by its path.
std::vector<PluggedTouchOutput> feedback_outputs(const std::vector<FoundFeedback>& found);

} // namespace tp
