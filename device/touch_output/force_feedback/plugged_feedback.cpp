// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/force_feedback/plugged_feedback.hpp"

#include "device/bus_mutex.hpp"
#include "device/touch_output/force_feedback/feedback_output.hpp"

#include <algorithm>
#include <mutex>

namespace tp {

std::vector<PluggedTouchOutput> feedback_outputs(const std::vector<FoundFeedback>& found) {
    std::vector<PluggedTouchOutput> outputs;
    for (const FoundFeedback& one : found) {
        const std::string by_number = "motor:" + one.serial_number;
        const bool number_taken =
            std::any_of(outputs.begin(), outputs.end(),
                        [&by_number](const PluggedTouchOutput& other) { return other.name == by_number; });
        PluggedTouchOutput output;
        output.name = one.serial_number.empty() || number_taken ? "motor:" + one.path : by_number;
        output.about = one.name;
        output.serial_number = one.serial_number;
        output.means = plays_waves(one.kind) ? TouchMeans::ticks : TouchMeans::rumble;
        output.delay = feedback_delay_s(one.kind);
        output.make = [one]() -> std::unique_ptr<TouchOutput> {
            return std::make_unique<FeedbackOutput>(FeedbackOutput::Identity{one.name, one.serial_number},
                                                    [one] {
                                                        const std::lock_guard lock(bus_mutex());
                                                        return open_feedback(one);
                                                    });
        };
        outputs.push_back(std::move(output));
    }
    return outputs;
}

std::vector<PluggedTouchOutput> plugged_feedback() { return feedback_outputs(find_feedback()); }

} // namespace tp
