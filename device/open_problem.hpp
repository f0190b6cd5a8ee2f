// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tp {

/// Why a device that is plugged in cannot be opened.
enum class OpenProblem {
    permission,
    serial_permission, ///< of a serial port
    wrong_driver,      ///< of a HID device
    wrong_usb_driver,  ///< of a device that is used through libusb
    busy,
    gone,
    other,
};

enum class System { linux_system, windows, macos };

/// The system that this program was built for.
System this_system();

/// What happened and what to do about it on that system, for a device called `name`.
std::string sentence(OpenProblem problem, System system, const std::string& name);

/// The problem that an errno of open(2) on a device's file stands for.
OpenProblem open_problem_of(int error_number);

} // namespace tp
