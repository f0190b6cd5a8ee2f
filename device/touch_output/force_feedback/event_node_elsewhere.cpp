// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/force_feedback/event_nodes.hpp"

namespace tp {

std::vector<FoundFeedback> find_feedback() { return {}; }

Result<std::unique_ptr<FeedbackNode>> open_feedback(const FoundFeedback& found) {
    return Error{"The " + found.name +
                 " cannot be used on this system: its vibration is used on Linux only."};
}

} // namespace tp
