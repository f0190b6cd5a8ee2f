// SPDX-License-Identifier: Apache-2.0
#include "device/usb/usb_devices.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <utility>

namespace tp {

namespace {

/// The number of the interface of that kind, if the device has it.
std::optional<int> interface_of(libusb_device* device, const UsbKind& kind) {
    libusb_config_descriptor* configuration = nullptr;
    if (libusb_get_active_config_descriptor(device, &configuration) != 0)
        return std::nullopt;
    const auto is = [](int wanted, std::uint8_t value) { return wanted < 0 || wanted == value; };
    std::optional<int> number;
    for (int i = 0; i < configuration->bNumInterfaces && !number; ++i) {
        if (configuration->interface[i].num_altsetting == 0)
            continue;
        const libusb_interface_descriptor& one = configuration->interface[i].altsetting[0];
        const auto has = [&one, &kind](std::uint8_t address) {
            return std::any_of(one.endpoint, one.endpoint + one.bNumEndpoints,
                               [address, &kind](const libusb_endpoint_descriptor& end) {
                                   return end.bEndpointAddress == address &&
                                          (end.bmAttributes & 3) == LIBUSB_TRANSFER_TYPE_BULK &&
                                          end.wMaxPacketSize >= kind.least_packet;
                               });
        };
        if (is(kind.interface_class, one.bInterfaceClass) &&
            is(kind.interface_subclass, one.bInterfaceSubClass) &&
            is(kind.interface_protocol, one.bInterfaceProtocol) && has(kind.in) && has(kind.out))
            number = one.bInterfaceNumber;
    }
    libusb_free_config_descriptor(configuration);
    return number;
}

std::string usb_place(libusb_device* device) {
    std::array<std::uint8_t, 7> ports{};
    const int count = libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
    std::string place = std::to_string(libusb_get_bus_number(device));
    for (int i = 0; i < count; ++i) {
        place += i == 0 ? '-' : '.';
        place += std::to_string(ports[static_cast<std::size_t>(i)]);
    }
    return place;
}

/// A string of the device, as far as this system tells it without ado: Linux keeps it in a file that
/// everybody may read, elsewhere the device must be asked.
std::string usb_string([[maybe_unused]] libusb_device* device, [[maybe_unused]] std::uint8_t index,
                       [[maybe_unused]] const char* file) {
    std::string text;
#if defined(__linux__)
    std::ifstream in("/sys/bus/usb/devices/" + usb_place(device) + "/" + file);
    std::getline(in, text);
#else
    libusb_device_handle* opened = nullptr;
    if (index == 0 || libusb_open(device, &opened) != 0)
        return text;
    const UsbHandle handle(opened);
    std::array<unsigned char, 128> bytes{};
    const int count =
        libusb_get_string_descriptor_ascii(opened, index, bytes.data(), static_cast<int>(bytes.size()));
    if (count > 0)
        text.assign(bytes.begin(), bytes.begin() + count);
#endif
    for (char& letter : text)
        if (letter < 0x20 || letter > 0x7E)
            letter = '?';
    return text;
}

} // namespace

UsbContext usb_context() {
    libusb_context* context = nullptr;
    return UsbContext(libusb_init(&context) == 0 ? context : nullptr);
}

std::vector<FoundUsb> find_usb(libusb_context* context, const UsbKind& kind) {
    std::vector<FoundUsb> found;
    libusb_device** all = nullptr;
    const auto count = libusb_get_device_list(context, &all);
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        libusb_device_descriptor about{};
        if (libusb_get_device_descriptor(all[i], &about) != 0 || about.idVendor != kind.vendor ||
            about.idProduct != kind.product)
            continue;
        if (const std::optional<int> interface = interface_of(all[i], kind))
            found.push_back({usb_place(all[i]), usb_string(all[i], about.iSerialNumber, "serial"),
                             usb_string(all[i], about.iProduct, "product"),
                             UsbDevice(libusb_ref_device(all[i])), *interface});
    }
    if (count >= 0)
        libusb_free_device_list(all, 1);
    return found;
}

OpenProblem open_problem_of_libusb(int error, System system) {
    switch (error) {
    case LIBUSB_ERROR_ACCESS: // macOS says this of a device that another program has open
        return system == System::macos ? OpenProblem::busy : OpenProblem::permission;
    case LIBUSB_ERROR_BUSY:
        return OpenProblem::busy;
    case LIBUSB_ERROR_NO_DEVICE:
    case LIBUSB_ERROR_IO:
        return OpenProblem::gone;
    case LIBUSB_ERROR_NOT_FOUND: // on Windows an interface that WinUSB does not drive
        return system == System::windows ? OpenProblem::wrong_usb_driver : OpenProblem::gone;
    case LIBUSB_ERROR_NOT_SUPPORTED:
        return OpenProblem::wrong_usb_driver;
    default:
        return OpenProblem::other;
    }
}

} // namespace tp
