// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/servo/force_device.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tp {

/// A device that can be used now.
struct ListedDevice {
    std::string name;  ///< "simulated", or as PluggedDevice has it ("pad:TP-0001"); what device_named takes
    std::string about; ///< as a person is told
    std::string serial_number;
    std::string interface; ///< "hid", "bulk"…: by which it is used now; empty for the simulated device
    /// It may be something else than a force device, or pull the wrong way: nobody gets it without asking for it.
    bool only_when_chosen = false;
    /// What its strength is kept by once a person has measured it (device/hid_pid/joystick_scale_file.hpp); empty where it
    /// knows its newtons itself.
    std::string scale_key = {};
};

/// The simulated device first, then what is plugged in, each once. Any thread; it may wait for another.
std::vector<ListedDevice> list_devices();

/// A device by its name, not yet open. An error where there is none of that name now. Any thread, as open()
/// of the device.
Result<std::unique_ptr<ForceDevice>> device_named(const std::string& name);

} // namespace tp
