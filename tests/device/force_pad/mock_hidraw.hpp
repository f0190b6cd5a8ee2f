// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../usb/usb_bed.hpp"
#include "device/force_pad/protocol/usb.hpp"

// GLib's header has a parameter of this name; hence also before Qt's headers.
#undef signals
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <linux/hidraw.h>
#include <span>
#include <string>
#include <sys/ioctl.h>
#include <umockdev-1.0/umockdev.h>

namespace tp::mock {

/// The HID interface of a force pad on the USB device 1-1, as umockdev takes it; its node is `hidraw_node`.
inline constexpr const char* hidraw_node = "/dev/hidraw0";
inline constexpr const char* hidraw_sys_path =
    "/sys/devices/pci0000:00/usb1/1-1/1-1:1.0/0003:1209:0001.0001/hidraw/hidraw0";

/// What /sys tells of a HID interface.
struct HidrawDevice {
    std::string name = "force pad";
    std::string serial_number = "TPC-0001";
    std::span<const std::uint8_t> descriptor = pad::report_descriptor;
    std::string vendor = "1209"; ///< of four hexadecimal digits
    std::string product = "0001";
};

inline std::string hidraw_description(const HidrawDevice& device = {}) {
    return "P: /devices/pci0000:00/usb1/1-1/1-1:1.0\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\n"
           "A: bInterfaceNumber=00\\n\n\n"
           "P: /devices/pci0000:00/usb1/1-1/1-1:1.0/0003:1209:0001.0001\nE: SUBSYSTEM=hid\n"
           "E: HID_ID=0003:0000" +
           device.vendor + ":0000" + device.product + "\nE: HID_NAME=" + device.name +
           "\nE: HID_PHYS=usb-0/input0\nE: HID_UNIQ=" + device.serial_number +
           "\nH: report_descriptor=" + hexadecimal(device.descriptor.data(), device.descriptor.size()) +
           "\n\nP: /devices/pci0000:00/usb1/1-1/1-1:1.0/0003:1209:0001.0001/hidraw/hidraw0\nN: hidraw0\n"
           "E: SUBSYSTEM=hidraw\nE: DEVNAME=/dev/hidraw0\nE: MAJOR=246\nE: MINOR=0\n"
           "L: device=../../../0003:1209:0001.0001\n\n";
}

/// What /sys tells of the USB device 1-1 that it is on.
inline std::string usb_description(const HidrawDevice& device = {}) {
    return "P: /devices/pci0000:00/usb1/1-1\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: idVendor=" +
           device.vendor + "\\n\nA: idProduct=" + device.product +
           "\\n\nA: manufacturer=touchphoto\\n\nA: product=" + device.name +
           "\\n\nA: serial=" + device.serial_number + "\\n\nA: bcdDevice=0100\\n\n\n";
}

/// Answers a question of the HID class with `bytes` of data at hand by `answer`, which gives what the system call returns,
/// negative for no answer; false where it is no question of that class.
template <typename Answer>
gboolean answer_hid_class(UMockdevIoctlClient* client, Answer answer) {
    const gulong request = umockdev_ioctl_client_get_request(client);
    if (_IOC_TYPE(request) != 'H')
        return FALSE;
    UMockdevIoctlData* data = umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0,
                                                          static_cast<gsize>(_IOC_SIZE(request)), nullptr);
    if (data == nullptr) {
        umockdev_ioctl_client_complete(client, -1, EFAULT);
        return TRUE;
    }
    const int answered = answer(request, std::span(data->data, static_cast<std::size_t>(_IOC_SIZE(request))));
    umockdev_ioctl_client_complete(client, answered < 0 ? -1 : answered, answered < 0 ? EINVAL : 0);
    umockdev_ioctl_data_unref(data);
    return TRUE;
}

/// What the kernel answers to the questions hidapi asks of any hidraw node; −1 to another one.
inline int descriptor_answer(gulong request, std::span<std::uint8_t> data, std::span<const std::uint8_t> descriptor) {
    if (request == HIDIOCGRDESCSIZE) {
        const int size = static_cast<int>(descriptor.size());
        std::memcpy(data.data(), &size, sizeof size);
        return 0;
    }
    if (request == HIDIOCGRDESC) {
        auto* told = reinterpret_cast<hidraw_report_descriptor*>(data.data());
        told->size = static_cast<std::uint32_t>(descriptor.size());
        std::memcpy(told->value, descriptor.data(), descriptor.size());
        return 0;
    }
    return -1;
}

inline gboolean answer_hidraw_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client) {
    return answer_hid_class(client, [](gulong request, std::span<std::uint8_t> data) {
        return descriptor_answer(request, data, pad::report_descriptor);
    });
}

} // namespace tp::mock
