// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/guard/force_guard.hpp"
#include "device/hid_pid/pid_reports.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tp {

/// What carries a stick's reports. One thread reads while another writes; the rest is for whoever opens it.
class PidTransport {
public:
    enum class Got {
        report,
        nothing, ///< within the wait
        lost,    ///< the device is gone; the transport stays so
    };

    virtual ~PidTransport() = default;
    /// What the device says of its reports, as bytes.
    virtual std::vector<std::uint8_t> descriptor() = 0;
    /// The next input report, as the system gives it; waits at most `wait_ms`, and not at all for 0.
    virtual Got read(hid::Report& report, int wait_ms) noexcept = 0;
    /// The input report whose id leads in it, as it is now; nothing where the device does not tell.
    virtual Got input_now(hid::Report& report) noexcept = 0;
    /// An output report. False where the device is gone. May block for as long as the system likes.
    virtual bool write(const hid::Report& report) noexcept = 0;
    /// The same, as far as it can be done from a signal handler (signal-safety(7)) and while another write
    /// hangs.
    virtual void write_from_signal(const hid::Report& report) noexcept = 0;
    virtual bool set_feature(const hid::Report& report) noexcept = 0;
    /// The feature report whose id leads in it. False where the device does not answer.
    virtual bool get_feature(hid::Report& report) noexcept = 0;
    /// Begins to guard the stick: `no_force` takes its force away, `at_the_end` follows where this program is
    /// gone. Once, by whoever opens it; an error where nothing would guard it.
    virtual Result<std::unique_ptr<ForceGuard>> guard(std::span<const hid::Report> no_force,
                                                      std::span<const hid::Report> at_the_end) = 0;
};

} // namespace tp
