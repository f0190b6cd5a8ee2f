// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/device_access.hpp"

#include "device/hid_pid/joystick_scale_file.hpp"
#include "device/usb/plug_watch.hpp"

#include <algorithm>
#include <utility>

namespace tp {

DeviceAccess DeviceAccess::of_this_computer(std::filesystem::path calibrations) {
    DeviceAccess access{list_devices, device_named, std::move(calibrations)};
    access.joystick_scales = joystick_scale_file();
    access.on_plug = [](std::function<void()> changed) { return std::make_shared<PlugWatch>(std::move(changed)); };
    return access;
}

QString key_of(const ListedDevice& device) {
    return QString::fromStdString(device.serial_number.empty() ? device.name : device.serial_number);
}

const ListedDevice* device_for(const std::vector<ListedDevice>& there, const QString& key) {
    if (key == no_device_key)
        return nullptr;
    const auto chosen =
        std::find_if(there.begin(), there.end(), [&key](const ListedDevice& one) { return key_of(one) == key; });
    if (chosen != there.end())
        return &*chosen;
    const auto sure =
        std::find_if(there.begin(), there.end(), [](const ListedDevice& one) { return !one.only_when_chosen; });
    return sure == there.end() ? nullptr : &*sure;
}

} // namespace tp
