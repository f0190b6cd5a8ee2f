// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/hid_pid/pid_transport.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tp {

/// A joystick that says of itself that it can be asked for a constant force.
struct FoundJoystick {
    std::string path; ///< the system's name for it
    std::string serial_number;
    std::string product;
};

/// Those on the HID bus now. Linux only: elsewhere this release of hidapi does not tell what a device says of
/// itself, and none is found. Calls of hidapi's enumeration: one thread at a time.
std::vector<FoundJoystick> find_joysticks();

/// Opens one; the program is the one that shall guard it (force_guard_program()). A stick that another
/// TouchPhoto uses, or has just left to its guard, is busy. The error is a sentence that says what to do on
/// this system.
Result<std::unique_ptr<PidTransport>> open_joystick(const FoundJoystick& stick,
                                                    const std::string& guard_program);

} // namespace tp
