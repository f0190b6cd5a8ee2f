// SPDX-License-Identifier: Apache-2.0
#include "device/open_problem.hpp"

#include <cerrno>

namespace tp {

System this_system() {
#if defined(_WIN32)
    return System::windows;
#elif defined(__APPLE__)
    return System::macos;
#else
    return System::linux_system;
#endif
}

std::string sentence(OpenProblem problem, System system, const std::string& name) {
    switch (problem) {
    case OpenProblem::permission:
        switch (system) {
        case System::linux_system:
            return "You are not allowed to use the " + name +
                   " yet. Copy resources/udev/70-touchphoto.rules to /etc/udev/rules.d, then unplug the "
                   "device and "
                   "plug it in again.";
        case System::windows:
            return "Windows does not let this program use the " + name +
                   ". Unplug it and plug it in again; if that does not help, close other programs that use "
                   "it.";
        case System::macos:
            return "macOS does not let this program use the " + name +
                   ". Allow it under System Settings, Privacy & Security, Input Monitoring, and start it "
                   "again.";
        }
        break;
    case OpenProblem::serial_permission:
        if (system != System::linux_system)
            return "Another program or the system keeps the " + name +
                   " from this one. Close other programs that use it, unplug it and plug it in again.";
        return "You are not allowed to use the " + name +
               " yet. Copy resources/udev/70-touchphoto.rules to /etc/udev/rules.d, then unplug the device "
               "and plug "
               "it in again; or have yourself added to the group dialout and log in again.";
    case OpenProblem::wrong_driver:
        switch (system) {
        case System::linux_system:
            return "Another driver of the system holds the " + name +
                   ". Unplug the device and plug it in again; if that does not help, its kernel must have "
                   "the hidraw "
                   "driver.";
        case System::windows:
            return "The " + name +
                   " has the wrong driver. In the Device Manager choose Update driver, then \"USB Input "
                   "Device\".";
        case System::macos:
            return "Another driver holds the " + name +
                   ". Remove the driver that its maker installed and start this computer again.";
        }
        break;
    case OpenProblem::wrong_usb_driver:
        switch (system) {
        case System::linux_system:
            return "Another driver of the system holds the " + name +
                   " and does not let go of it. Unplug the device, unload that driver and plug the device in "
                   "again.";
        case System::windows:
            return "The " + name +
                   " has the wrong driver. In the Device Manager choose Update driver, then \"WinUsb "
                   "Device\".";
        case System::macos:
            return sentence(OpenProblem::wrong_driver, system, name);
        }
        break;
    case OpenProblem::busy:
        return "Another program uses the " + name + ". Close that program and try again.";
    case OpenProblem::gone:
        return "The " + name + " was unplugged. Plug it in again.";
    case OpenProblem::other:
        break;
    }
    return "The " + name + " could not be opened. Unplug it, plug it in again and try once more.";
}

OpenProblem open_problem_of(int error_number) {
    switch (error_number) {
    case EACCES:
    case EPERM:
        return OpenProblem::permission;
    case EBUSY:
        return OpenProblem::busy;
    case ENOENT:
    case ENODEV:
    case ENXIO:
    case EIO:
        return OpenProblem::gone;
    case ENOTTY:
    case EINVAL:
        return OpenProblem::wrong_driver;
    default:
        return OpenProblem::other;
    }
}

} // namespace tp
