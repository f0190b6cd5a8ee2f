// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/servo/force_device.hpp"
#include "device/registry.hpp"

#include <QString>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tp {

/// How pages come to force devices. One without a list has none; a test brings devices of its own. Both functions are
/// called on a thread that may wait.
struct DeviceAccess {
    std::function<std::vector<ListedDevice>()> list;
    std::function<Result<std::unique_ptr<ForceDevice>>(const std::string& name)> make;
    std::filesystem::path calibrations; ///< file (device/calibration_file.hpp); empty: none are kept
    std::filesystem::path joystick_scales =
        {}; ///< file (device/hid_pid/joystick_scale_file.hpp); empty: none are kept
    int look_every_ms = 2000;           ///< how soon a device that is plugged in is found where nothing tells of it
    /// Calls on any thread when something was plugged in or out, for as long as what it returns lives; empty: nothing tells.
    std::function<std::shared_ptr<void>(std::function<void()> changed)> on_plug = {};

    /// Those of this computer, as device/registry.hpp has them.
    static DeviceAccess of_this_computer(std::filesystem::path calibrations);
};

/// What the choice of a device is remembered by: its serial number, or its name where it has none.
QString key_of(const ListedDevice& device);

/// As key_of would have it for a person who wants no force device, even where there is one.
inline constexpr const char* no_device_key = "simulated";

/// The one of these real devices that serves a person who chose `key`: that one; where it is not there or nothing
/// was chosen, the first of those that need not be chosen. Null for none.
const ListedDevice* device_for(const std::vector<ListedDevice>& there, const QString& key);

} // namespace tp
