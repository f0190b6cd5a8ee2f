// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/force_pad/found_pad.hpp"
#include "device/force_pad/report_transport.hpp"

#include <memory>
#include <vector>

namespace tp {

/// Those on the HID bus now. Calls of hidapi's enumeration: one thread at a time.
std::vector<FoundPad> find_hid();

/// Opens one. The error is a sentence that says what to do on this system.
Result<std::unique_ptr<ReportTransport>> open_hid(const FoundPad& pad);

} // namespace tp
