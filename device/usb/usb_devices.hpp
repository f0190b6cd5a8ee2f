// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/open_problem.hpp"

#include <cstddef>
#include <cstdint>
#include <libusb.h>
#include <memory>
#include <string>
#include <vector>

namespace tp {

struct ExitUsb {
    void operator()(libusb_context* context) const { libusb_exit(context); }
};
struct CloseUsb {
    void operator()(libusb_device_handle* device) const { libusb_close(device); }
};
struct ForgetUsb {
    void operator()(libusb_device* device) const { libusb_unref_device(device); }
};
using UsbContext = std::unique_ptr<libusb_context, ExitUsb>;
using UsbHandle = std::unique_ptr<libusb_device_handle, CloseUsb>;
using UsbDevice = std::unique_ptr<libusb_device, ForgetUsb>;

/// libusb's set-up of its own for one who uses it; empty where libusb cannot work. Nothing of a context may
/// outlive it.
UsbContext usb_context();

/// What of a device makes it one that a back end looks for: an interface with two bulk endpoints.
struct UsbKind {
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    std::uint8_t in = 0;          ///< address of the endpoint to the computer
    std::uint8_t out = 0;         ///< and of the one from it
    std::size_t least_packet = 1; ///< bytes that a packet of either holds at least
    int interface_class = -1;     ///< with subclass and protocol; −1: any
    int interface_subclass = -1;
    int interface_protocol = -1;
};

/// A device of a kind on the USB now.
struct FoundUsb {
    std::string path; ///< the place it is plugged in, as Linux writes it: "1-4.2"
    std::string serial_number;
    std::string product;
    UsbDevice device;
    int interface = 0; ///< that has the endpoints
};
std::vector<FoundUsb> find_usb(libusb_context* context, const UsbKind& kind);

/// The descriptor through which this process has a device open, with all that it has claimed; libusb tells
/// none. −1 where the system does not tell it either, or where there are several.
int usb_descriptor(libusb_device* device);

/// The problem that an error of libusb stands for when a device is opened or its interface claimed.
OpenProblem open_problem_of_libusb(int error, System system);

} // namespace tp
