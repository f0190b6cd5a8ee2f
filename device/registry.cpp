// SPDX-License-Identifier: Apache-2.0
#include "device/registry.hpp"

#include "device/bus_mutex.hpp"
#include "device/falcon/plugged_falcons.hpp"
#include "device/force_pad/plugged_pads.hpp"
#include "device/haply_2diy/plugged_boards.hpp"
#include "device/hid_pid/plugged_joysticks.hpp"
#include "device/plugged_device.hpp"
#include "device/simulated/simulated_device.hpp"

#include <iterator>
#include <mutex>

namespace tp {

namespace {

constexpr const char* simulated = "simulated";

/// What each back end sees on its bus now.
std::vector<PluggedDevice> plugged_devices() {
    std::vector<PluggedDevice> all;
    for (const auto look : {plugged_pads, plugged_joysticks, plugged_boards, plugged_falcons}) {
        std::vector<PluggedDevice> seen = look();
        std::move(seen.begin(), seen.end(), std::back_inserter(all));
    }
    return all;
}

} // namespace

std::vector<ListedDevice> list_devices() {
    const std::lock_guard lock(bus_mutex());
    std::vector<ListedDevice> devices{{simulated, "the mouse or a finger on the screen", "", ""}};
    for (const PluggedDevice& device : plugged_devices())
        devices.push_back({device.name, device.about, device.serial_number, device.interface(),
                           device.only_when_chosen, device.scale_key});
    return devices;
}

Result<std::unique_ptr<ForceDevice>> device_named(const std::string& name) {
    if (name == simulated)
        return std::unique_ptr<ForceDevice>(std::make_unique<SimulatedDevice>(200.0, 150.0));
    const std::lock_guard lock(bus_mutex());
    for (const PluggedDevice& device : plugged_devices())
        if (device.name == name)
            return device.make();
    return Error{"There is no device \"" + name +
                 "\" now. Check that it is plugged in; \"touchphoto-lab devices\" lists what is there."};
}

} // namespace tp
