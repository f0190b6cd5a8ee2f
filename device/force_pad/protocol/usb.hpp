// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/force_pad/protocol/frame.hpp"

/// How a force pad shows itself on USB (../PROTOCOL.md).
namespace tp::pad {

inline constexpr uint16_t usb_vendor = 0x1209; ///< pid.codes
inline constexpr uint16_t usb_product =
    0x0001;                                    ///< its id for private tests, until the pad has one of its own
inline constexpr uint16_t usage_page = 0xFF54; ///< vendor page
inline constexpr uint16_t usage = 0x0001;

// The bulk interface is told by these three and by its endpoints.
inline constexpr uint8_t bulk_class = 0xFF;
inline constexpr uint8_t bulk_subclass = 0x54;
inline constexpr uint8_t bulk_protocol = 0x01;
inline constexpr uint8_t bulk_out = 0x02; ///< endpoint addresses
inline constexpr uint8_t bulk_in = 0x81;

/// One input and one output report of 32 bytes, no report ids.
inline constexpr uint8_t report_descriptor[] = {
    0x06, 0x54, 0xFF, // Usage Page (Vendor 0xFF54)
    0x09, 0x01,       // Usage (1)
    0xA1, 0x01,       // Collection (Application)
    0x15, 0x00,       //   Logical Minimum (0)
    0x26, 0xFF, 0x00, //   Logical Maximum (255)
    0x75, 0x08,       //   Report Size (8)
    0x95, 0x20,       //   Report Count (32)
    0x09, 0x02,       //   Usage (2)
    0x81, 0x02,       //   Input (Data, Variable, Absolute)
    0x95, 0x20,       //   Report Count (32)
    0x09, 0x03,       //   Usage (3)
    0x91, 0x02,       //   Output (Data, Variable, Absolute)
    0xC0,             // End Collection
};

} // namespace tp::pad
