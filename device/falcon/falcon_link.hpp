// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/falcon/ftdi.hpp"
#include "device/guard/force_guard.hpp"
#include "device/usb/usb_packet.hpp"

#include <cstdint>
#include <memory>
#include <span>

namespace tp {

/// The way to a Falcon: its serial bridge on the USB. One thread reads while another writes.
class FalconLink {
public:
    virtual ~FalconLink() = default;
    /// A control request of the bridge; false where the device is gone.
    virtual bool control(const falcon::ftdi::Request& request) noexcept = 0;
    /// The next packet, its two status bytes included; waits at most `wait_ms`, and not at all for 0.
    virtual UsbGot read(UsbPacket& packet, int wait_ms) noexcept = 0;
    /// At most 64 bytes. False where the device is gone. May block for as long as the system likes.
    virtual bool write(std::span<const std::uint8_t> bytes) noexcept = 0;
    /// Begins to guard the Falcon, whose force such a packet takes away. Once, by whoever opens it; an error
    /// where nothing would guard it.
    virtual Result<std::unique_ptr<ForceGuard>> guard(std::span<const std::uint8_t> no_force) = 0;
};

} // namespace tp
