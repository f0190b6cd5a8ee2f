// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/haply_2diy/serial_line.hpp"
#include "device/system_handle.hpp"

#include <memory>
#include <string>

namespace tp {

/// A serial port of this computer that carries bytes as they are; no other program can open it meanwhile. A
/// write gives up, as on a line that is gone, when nothing moves for a second.
class SerialPort : public SerialLine {
public:
    /// Its owner stays this object.
    virtual SystemHandle handle() const = 0;
};

/// The port at `path`: "/dev/ttyACM0", on Windows "COM7". The error says what to do for a device called
/// `name`.
Result<std::unique_ptr<SerialPort>> open_serial_port(const std::string& path, const std::string& name);

} // namespace tp
