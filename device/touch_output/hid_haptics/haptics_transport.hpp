// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/hid_haptics/haptics_reports.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tp {

/// What carries the reports of a device with haptics. One thread reads while another sends; the rest is for whoever opens it.
class HapticsTransport {
public:
    enum class Got {
        report,
        nothing, ///< within the wait
        lost,    ///< the device is gone; the transport stays so
    };
    struct Input {
        std::array<std::uint8_t, 256> bytes{};
        std::size_t size = 0;

        std::span<const std::uint8_t> all() const { return std::span(bytes).first(size); }
    };

    virtual ~HapticsTransport() = default;
    /// What the device says of its reports, as bytes.
    virtual std::vector<std::uint8_t> descriptor() = 0;
    /// The feature report of that id, at most `bytes` behind the id, without it; empty where the device does not answer.
    virtual std::vector<std::uint8_t> feature(std::uint8_t id, std::size_t bytes) = 0;
    /// The next input report, as the system gives it; waits at most `wait_ms`, and not at all for 0.
    virtual Got read(Input& report, int wait_ms) noexcept = 0;
    /// False where it was not taken. May block for as long as the system likes.
    virtual bool send(const haptics::Output& report) noexcept = 0;
};

} // namespace tp
