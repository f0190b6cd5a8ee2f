// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/force_device.hpp"

#include <functional>
#include <memory>
#include <string>

namespace tp {

/// A device that a bus shows now, as its back end gives it to the registry. Whoever calls `interface` holds
/// bus_mutex().
struct PluggedDevice {
    std::string name; ///< the back end's word, a colon, and the serial number or, where it has none, its path
    std::string about; ///< as a person is told
    std::string serial_number;
    std::function<std::string()>
        interface; ///< by which it would be used now; may open the device to find out
    /// Its back end, not yet open, whose open() holds bus_mutex() itself.
    std::function<std::unique_ptr<ForceDevice>()> make;
    /// ListedDevice has what it means.
    bool only_when_chosen = false;
    std::string scale_key = {};
};

} // namespace tp
