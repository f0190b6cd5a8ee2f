// SPDX-License-Identifier: Apache-2.0
#include "device/usb/usb_devices.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>

namespace tp {

int usb_descriptor(libusb_device* device) {
    int found = -1;
    std::array<char, 32> node{};
    std::snprintf(node.data(), node.size(), "/dev/bus/usb/%03u/%03u", unsigned{libusb_get_bus_number(device)},
                  unsigned{libusb_get_device_address(device)});
    struct stat wanted {};
    if (::stat(node.data(), &wanted) != 0)
        return -1;
    std::error_code problem;
    for (std::filesystem::directory_iterator at("/proc/self/fd", problem), end; !problem && at != end;
         at.increment(problem)) {
        const int descriptor = std::atoi(at->path().filename().c_str());
        struct stat one {};
        if (::fstat(descriptor, &one) != 0 || one.st_dev != wanted.st_dev || one.st_ino != wanted.st_ino)
            continue;
        if (found >= 0)
            return -1;
        found = descriptor;
    }
    return found;
}

} // namespace tp
