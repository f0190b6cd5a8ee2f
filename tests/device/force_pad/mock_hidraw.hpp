// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/force_pad/protocol/usb.hpp"

// GLib's header has a parameter of this name; hence also before Qt's headers.
#undef signals
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <linux/hidraw.h>
#include <string>
#include <sys/ioctl.h>
#include <umockdev-1.0/umockdev.h>

namespace tp::mock {

/// The HID interface of a force pad on the USB device 1-1, as umockdev takes it; its node is `hidraw_node`.
inline constexpr const char* hidraw_node = "/dev/hidraw0";
inline constexpr const char* hidraw_sys_path =
    "/sys/devices/pci0000:00/usb1/1-1/1-1:1.0/0003:1209:0001.0001/hidraw/hidraw0";

inline std::string hexadecimal(const std::uint8_t* bytes, std::size_t count) {
    constexpr const char* digits = "0123456789ABCDEF";
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        text += digits[bytes[i] >> 4];
        text += digits[bytes[i] & 0xF];
    }
    return text;
}

inline std::string hidraw_description() {
    return "P: /devices/pci0000:00/usb1/1-1/1-1:1.0\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\n"
           "A: bInterfaceNumber=00\\n\n\n"
           "P: /devices/pci0000:00/usb1/1-1/1-1:1.0/0003:1209:0001.0001\nE: SUBSYSTEM=hid\n"
           "E: HID_ID=0003:00001209:00000001\nE: HID_NAME=force pad\nE: HID_PHYS=usb-0/input0\n"
           "E: HID_UNIQ=TPC-0001\nH: report_descriptor=" +
           hexadecimal(pad::report_descriptor, sizeof pad::report_descriptor) +
           "\n\nP: /devices/pci0000:00/usb1/1-1/1-1:1.0/0003:1209:0001.0001/hidraw/hidraw0\nN: hidraw0\n"
           "E: SUBSYSTEM=hidraw\nE: DEVNAME=/dev/hidraw0\nE: MAJOR=246\nE: MINOR=0\n"
           "L: device=../../../0003:1209:0001.0001\n\n";
}

/// What the kernel answers to the questions hidapi asks of a hidraw node.
inline gboolean answer_hidraw_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client) {
    const gulong request = umockdev_ioctl_client_get_request(client);
    if (_IOC_TYPE(request) != 'H')
        return FALSE;
    UMockdevIoctlData* data = umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0,
                                                          static_cast<gsize>(_IOC_SIZE(request)), nullptr);
    if (data == nullptr) {
        umockdev_ioctl_client_complete(client, -1, EFAULT);
        return TRUE;
    }
    if (request == HIDIOCGRDESCSIZE) {
        const int size = sizeof pad::report_descriptor;
        std::memcpy(data->data, &size, sizeof size);
        umockdev_ioctl_client_complete(client, 0, 0);
    } else if (request == HIDIOCGRDESC) {
        auto* descriptor = reinterpret_cast<hidraw_report_descriptor*>(data->data);
        descriptor->size = sizeof pad::report_descriptor;
        std::memcpy(descriptor->value, pad::report_descriptor, sizeof pad::report_descriptor);
        umockdev_ioctl_client_complete(client, 0, 0);
    } else {
        umockdev_ioctl_client_complete(client, -1, EINVAL);
    }
    umockdev_ioctl_data_unref(data);
    return TRUE;
}

} // namespace tp::mock
