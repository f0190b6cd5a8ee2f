// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/force_pad/protocol/frame.hpp"

namespace tp {

/// What carries a force pad's frames: reports of 32 bytes each way. One thread reads while another writes.
class ReportTransport {
public:
    enum class Got {
        report,
        nothing, ///< within the wait
        odd,     ///< a report of another length
        lost,    ///< the device is gone; the transport stays so
    };

    virtual ~ReportTransport() = default;
    /// The next report; waits at most `wait_ms`, and not at all for 0.
    virtual Got read(pad::Frame& frame, int wait_ms) noexcept = 0;
    /// False where the device is gone. May block for as long as the system likes.
    virtual bool write(const pad::Frame& frame) noexcept = 0;
};

} // namespace tp
