// SPDX-License-Identifier: Apache-2.0
#include "device/registry.hpp"

#include "device/force_pad/force_pad.hpp"
#include "device/force_pad/hid_transport.hpp"
#include "device/simulated/simulated_device.hpp"

namespace tp {

namespace {

constexpr const char* simulated = "simulated";

std::string name_of(const FoundPad& found) {
    return "pad:" + (found.serial_number.empty() ? found.path : found.serial_number);
}

} // namespace

std::vector<ListedDevice> list_devices() {
    std::vector<ListedDevice> devices{{simulated, "the mouse or a finger on the screen", ""}};
    for (const FoundPad& found : find_pads())
        devices.push_back(
            {name_of(found), found.product.empty() ? "force pad" : found.product, found.serial_number});
    return devices;
}

Result<std::unique_ptr<ForceDevice>> device_named(const std::string& name) {
    if (name == simulated)
        return std::unique_ptr<ForceDevice>(std::make_unique<SimulatedDevice>(200.0, 150.0));
    for (const FoundPad& found : find_pads())
        if (name_of(found) == name)
            return std::unique_ptr<ForceDevice>(
                std::make_unique<ForcePad>([found] { return open_hid(found); }));
    return Error{"There is no device \"" + name +
                 "\" now. See that it is plugged in; \"touchphoto-lab devices\" lists what is there."};
}

} // namespace tp
