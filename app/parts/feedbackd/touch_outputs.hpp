// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/touch_output/touch_registry.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tp {

/// What device/touch_output lists and, behind it, feedbackd's motor. Any thread; it may wait for half a second.
std::vector<ListedTouchOutput> touch_outputs_here();

/// One of them by its name, not yet open; as touch_output_named.
Result<std::unique_ptr<TouchOutput>> touch_output_here(const std::string& name);

} // namespace tp
