// SPDX-License-Identifier: Apache-2.0
#include "device/falcon/plugged_falcons.hpp"

#include "device/bus_mutex.hpp"
#include "device/falcon/falcon.hpp"
#include "device/falcon/falcon_usb.hpp"
#include "device/falcon/firmware_image.hpp"
#include "device/guard/guard_process.hpp"

#include <mutex>

namespace tp {

std::vector<PluggedDevice> plugged_falcons() {
    std::vector<PluggedDevice> devices;
    for (const FoundFalcon& found : find_falcons()) {
        const auto open = [found] {
            const std::lock_guard lock(bus_mutex());
            return open_falcon(found, force_guard_program());
        };
        devices.push_back({"falcon:" + (found.serial_number.empty() ? found.path : found.serial_number),
                           "Novint Falcon", found.serial_number, [] { return "usb"; },
                           [open, found] {
                               return std::make_unique<Falcon>(
                                   open, [] { return falcon::firmware_in(falcon::firmware_file()); },
                                   found.serial_number);
                           }});
    }
    return devices;
}

} // namespace tp
