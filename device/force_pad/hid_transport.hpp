// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/force_pad/report_transport.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tp {

/// A device on the HID bus with a force pad's ids; whether it is one it must say itself.
struct FoundPad {
    std::string path; ///< the system's name for it
    std::string serial_number;
    std::string product;
};

/// Those plugged in now. Calls of hidapi's enumeration: one thread at a time.
std::vector<FoundPad> find_pads();

/// Opens one. The error is a sentence that says what to do on this system.
Result<std::unique_ptr<ReportTransport>> open_hid(const FoundPad& pad);

} // namespace tp
