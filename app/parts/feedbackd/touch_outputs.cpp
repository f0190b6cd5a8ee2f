// SPDX-License-Identifier: Apache-2.0
#include "app/parts/feedbackd/touch_outputs.hpp"

#include "app/parts/feedbackd/feedbackd_bus.hpp"

namespace tp {

std::vector<ListedTouchOutput> touch_outputs_here() {
    std::vector<ListedTouchOutput> outputs = list_touch_outputs();
    for (const PluggedTouchOutput& output : plugged_feedbackd())
        outputs.push_back(
            {output.name, output.about, output.serial_number, output.means, output.is_pad, output.delay});
    return outputs;
}

Result<std::unique_ptr<TouchOutput>> touch_output_here(const std::string& name) {
    for (const PluggedTouchOutput& output : plugged_feedbackd())
        if (output.name == name)
            return output.make();
    return touch_output_named(name);
}

} // namespace tp
