// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/force_pad/found_pad.hpp"
#include "device/force_pad/report_transport.hpp"

#include <memory>
#include <vector>

namespace tp {

/// Those on the USB now that have the bulk interface of PROTOCOL.md; none where libusb cannot work.
std::vector<FoundPad> find_bulk();

/// Opens the one with this serial number wherever it is plugged in, or without a number the one at this
/// place, and takes its bulk interface for itself, from another driver if need be. The error is a sentence
/// that says what to do on this system.
///
/// Reading with a wait of 0 makes no call to the system (BulkPipe). A write that the pad does not take within
/// 100 ms is dropped and counts as done.
Result<std::unique_ptr<ReportTransport>> open_bulk(const FoundPad& pad);

} // namespace tp
