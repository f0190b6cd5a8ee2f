// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "virtual_device.hpp"

#include <string>

namespace tp::vm {

/// Where a virtual device meets the kernel.
class Port {
public:
    virtual ~Port() = default;
    /// False, with a word on stderr, where the kernel does not want it.
    virtual bool plug_in() = 0;
    virtual void unplug() = 0;
    /// Readable when the kernel has something for the device; -1 while it is not plugged in.
    virtual int file() const = 0;
    /// Takes one thing in from a readable file. False where the kernel has let go of the device.
    virtual bool take_in() = 0;
    /// Passes on what the device says. False as above.
    virtual bool pass_on() = 0;
};

/// The device's own clock and its life, until the standard input ends: a millisecond is a step, whatever the
/// kernel does, and a row in the log `log_file`. A letter on the standard input does something to it: p plugs
/// it in, u unplugs it, s silences it, t lets it talk again. What serve() returns is the program's exit
/// status.
int serve(VirtualDevice& device, Port& port, const std::string& log_file);

} // namespace tp::vm
