// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/hid_haptics/plugged_haptic_pads.hpp"

#include "device/bus_mutex.hpp"
#include "device/touch_output/hid_haptics/haptic_pad.hpp"
#include "device/touch_output/hid_haptics/hid_haptics_transport.hpp"

#include <mutex>
#include <utility>

namespace tp {

namespace {

Result<std::unique_ptr<HapticsTransport>> open_now(const FoundHapticPad& pad) {
    const std::lock_guard lock(bus_mutex());
    return open_haptic_pad(pad);
}

} // namespace

std::vector<PluggedTouchOutput> plugged_haptic_pads() {
    std::vector<PluggedTouchOutput> outputs;
    for (const FoundHapticPad& pad : find_haptic_pads()) {
        PluggedTouchOutput output;
        output.name = "haptics:" + (pad.serial_number.empty() ? pad.path : pad.serial_number);
        output.about = pad.product.empty() ? "touch pad with haptics" : pad.product;
        output.serial_number = pad.serial_number;
        output.means = TouchMeans::ticks;
        output.delay = HapticPad::delay_s;
        output.is_pad = pad.tells_place;
        output.make = [pad] {
            return std::make_unique<HapticPad>([pad] { return open_now(pad); },
                                               HapticPad::Identity{pad.product, pad.serial_number});
        };
        outputs.push_back(std::move(output));
    }
    return outputs;
}

} // namespace tp
