// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/touch_registry.hpp"

#include "device/bus_mutex.hpp"
#include "device/touch_output/force_feedback/plugged_feedback.hpp"
#include "device/touch_output/hid_haptics/plugged_haptic_pads.hpp"
#include "device/touch_output/plugged_touch_output.hpp"
#include "device/touch_output/steam_pad/plugged_steam_pads.hpp"

#include <iterator>
#include <mutex>

namespace tp {

namespace {

using Look = std::vector<PluggedTouchOutput> (*)();

/// How each back end sees what is there now.
const std::vector<Look> looks{
    plugged_steam_pads,
    plugged_haptic_pads,
    plugged_feedback,
};

std::vector<PluggedTouchOutput> plugged_touch_outputs() {
    std::vector<PluggedTouchOutput> all;
    for (const Look look : looks) {
        std::vector<PluggedTouchOutput> seen = look();
        std::move(seen.begin(), seen.end(), std::back_inserter(all));
    }
    return all;
}

} // namespace

std::vector<ListedTouchOutput> list_touch_outputs() {
    const std::lock_guard lock(bus_mutex());
    std::vector<ListedTouchOutput> outputs;
    for (const PluggedTouchOutput& output : plugged_touch_outputs())
        outputs.push_back(
            {output.name, output.about, output.serial_number, output.means, output.is_pad, output.delay});
    return outputs;
}

Result<std::unique_ptr<TouchOutput>> touch_output_named(const std::string& name) {
    const std::lock_guard lock(bus_mutex());
    for (const PluggedTouchOutput& output : plugged_touch_outputs())
        if (output.name == name)
            return output.make();
    return Error{"There is no touch output \"" + name +
                 "\" now. Check that it is plugged in; \"touchphoto-lab devices\" lists what is there."};
}

} // namespace tp
