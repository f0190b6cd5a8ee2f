// SPDX-License-Identifier: Apache-2.0
#include "device/hid_pid/plugged_joysticks.hpp"

#include "device/bus_mutex.hpp"
#include "device/guard/guard_process.hpp"
#include "device/hid_pid/hid_pid_transport.hpp"
#include "device/hid_pid/joystick_scale_file.hpp"
#include "device/hid_pid/pid_joystick.hpp"

#include <memory>
#include <mutex>
#include <string>

namespace tp {

std::vector<PluggedDevice> plugged_joysticks() {
    std::vector<PluggedDevice> devices;
    for (const FoundJoystick& found : find_joysticks()) {
        const auto open_this = [found] {
            const std::lock_guard lock(bus_mutex());
            return open_joystick(found, force_guard_program());
        };
        const std::string key = found.serial_number.empty() ? found.product : found.serial_number;
        const JoystickScale scale = kept_joystick_scale(joystick_scale_file(), key);
        devices.push_back({"stick:" + (found.serial_number.empty() ? found.path : found.serial_number),
                           found.product.empty() ? "force stick" : found.product, found.serial_number,
                           [] { return std::string("hid"); },
                           [open_this, found, scale] {
                               return std::make_unique<PidJoystick>(
                                   open_this, PidJoystick::Identity{found.product, found.serial_number},
                                   scale);
                           },
                           !scale.measured, key});
    }
    return devices;
}

} // namespace tp
