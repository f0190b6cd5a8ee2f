// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/usb/usb_devices.hpp"
#include "device/usb/usb_packet.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace tp {

/// Two bulk endpoints of a device on the USB: packets in, packets out. One thread reads while another writes.
///
/// Reading with a wait of 0 makes no call to the system and waits for nobody: a thread of the pipe takes the
/// packets in, of which it keeps the newest 64. A halted endpoint is opened again; 64 errors in a row, or the
/// system's word, and the device is lost.
class BulkPipe {
public:
    virtual ~BulkPipe() = default;
    /// The next packet; waits at most `wait_ms`, and not at all for 0.
    virtual UsbGot read(UsbPacket& packet, int wait_ms) noexcept = 0;
    /// At most 64 bytes; false where the device is gone. What it does not take within 100 ms is dropped and
    /// counts as done.
    virtual bool write(std::span<const std::uint8_t> bytes) noexcept = 0;
    /// A control request to the device without data, by the thread that writes; false where the device is
    /// gone. One that it refuses, or does not take within 100 ms, counts as done.
    virtual bool control(std::uint8_t type, std::uint8_t request, std::uint16_t value,
                         std::uint16_t index) noexcept = 0;
    /// What a process that is started with it writes to the same endpoints with, for as long as the pipe is
    /// open, and after this process has ended; −1 where the system has no such thing.
    virtual int descriptor() const = 0;
};

/// Opens the one of that kind with this serial number wherever it is plugged in, or without a number the one
/// at this place, and takes its interface for itself, from another driver if need be. The error is a sentence
/// that says what to do on this system with a device called `name`.
Result<std::unique_ptr<BulkPipe>> open_pipe(const UsbKind& kind, const std::string& serial_number,
                                            const std::string& path, const std::string& name);

} // namespace tp
