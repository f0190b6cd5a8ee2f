// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

/// The serial bridge (FTDI FT232) through which a Falcon is reached: its control requests as values, and what
/// it puts before the bytes it has received. Facts: libnifalcon at f7c727a.
namespace tp::falcon::ftdi {

/// A vendor request to the device without data: bmRequestType 0x40, wIndex 0.
struct Request {
    std::uint8_t request = 0;
    std::uint16_t value = 0;
    bool operator==(const Request&) const = default;
};
inline constexpr std::uint8_t request_type = 0x40;

inline constexpr Request reset{0, 0};
inline constexpr Request purge_received{0, 1};
inline constexpr Request purge_to_send{0, 2};
inline constexpr Request dtr_low{1, 0x0100};
inline constexpr Request dtr_high{1, 0x0101};
inline constexpr Request rts_low{1, 0x0200};
inline constexpr Request no_flow_control{2, 0};
inline constexpr Request baud_9600{3, 0x4138};    ///< 3 MHz / 312.5
inline constexpr Request baud_142857{3, 0x0015};  ///< 3 MHz / 21
inline constexpr Request baud_1500000{3, 0x0002}; ///< 3 MHz / 2
inline constexpr Request eight_bits_no_parity{4, 0x0008};
/// What has been received is sent to the computer after that time, even if it is nothing.
constexpr Request latency(std::uint16_t ms) { return {9, ms}; }

/// Each packet of at most 64 bytes to the computer begins with two of modem and line status.
inline constexpr std::size_t status_size = 2;
inline constexpr std::size_t most_payload = 62;
inline constexpr std::uint8_t clear_to_send = 0x10; ///< in the first status byte

/// A packet taken apart.
struct Received {
    bool clear_to_send = false;
    std::span<const std::uint8_t> payload;
};
constexpr Received received(std::span<const std::uint8_t> packet) {
    if (packet.size() < status_size)
        return {};
    return {(packet[0] & clear_to_send) != 0, packet.subspan(status_size)};
}

} // namespace tp::falcon::ftdi
