// SPDX-License-Identifier: Apache-2.0
#pragma once

// GLib's header has a parameter of this name.
#undef signals

#include <string>
#include <termios.h>
#include <umockdev-1.0/umockdev.h>

namespace tp::mock {

/// Plugs in what umockdev's `description` shows, with one that answers the ioctls of its node. The device's end of that node,
/// a descriptor of the test bed on which bytes pass as they are; below 0 where that cannot be.
inline int plugged_in(UMockdevTestbed* bed, const std::string& description, const char* node,
                      UMockdevIoctlBase* ioctls) {
    if (umockdev_testbed_add_from_string(bed, description.c_str(), nullptr) == FALSE ||
        umockdev_testbed_attach_ioctl(bed, node, ioctls, nullptr) == FALSE)
        return -1;
    const int file = umockdev_testbed_get_dev_fd(bed, node);
    termios raw{};
    if (file < 0 || tcgetattr(file, &raw) != 0)
        return -1;
    cfmakeraw(&raw);
    return tcsetattr(file, TCSANOW, &raw) == 0 ? file : -1;
}

} // namespace tp::mock
