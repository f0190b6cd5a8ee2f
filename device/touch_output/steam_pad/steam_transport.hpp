// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/steam_pad/steam_reports.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tp {

/// What carries the reports of a controller with Steam pads. One thread reads while another sends.
class SteamTransport {
public:
    enum class Got {
        report,
        nothing, ///< within the wait
        lost,    ///< the device is gone; the transport stays so
    };
    struct Input {
        std::array<std::uint8_t, steam::input_bytes> bytes{};
        std::size_t size = 0;

        std::span<const std::uint8_t> all() const { return std::span(bytes).first(size); }
    };

    virtual ~SteamTransport() = default;
    virtual steam::Kind kind() const = 0;
    /// The next input report; waits at most `wait_ms`, and not at all for 0.
    virtual Got read(Input& report, int wait_ms) noexcept = 0;
    /// False where it was not taken: a controller on the radio may refuse for a while, one that is gone always does. May block
    /// for as long as the system likes.
    virtual bool send(const steam::Feature& report) noexcept = 0;
};

} // namespace tp
