// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/touch_output/hid_haptics/haptics_transport.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tp {

/// A device that says of itself that it has haptics.
struct FoundHapticPad {
    std::string path; ///< the system's name for it
    std::string serial_number;
    std::string product;
    bool tells_place = false; ///< it is a touch pad whose size it tells
};

/// Those on the HID bus now. Linux only: elsewhere this release of hidapi does not tell what a device says of itself, and none is
/// found. Calls of hidapi's enumeration: one thread at a time.
std::vector<FoundHapticPad> find_haptic_pads();

/// Opens one. One that another TouchPhoto uses is busy. The error is a sentence that says what to do on this system.
Result<std::unique_ptr<HapticsTransport>> open_haptic_pad(const FoundHapticPad& pad);

} // namespace tp
