// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tp {

/// What one packet of a bulk endpoint at full speed carries.
struct UsbPacket {
    std::array<std::uint8_t, 64> bytes{};
    std::size_t size = 0; ///< above 64 where more came than is kept

    bool whole() const { return size <= bytes.size(); }
    /// Empty where it is not whole.
    std::span<const std::uint8_t> content() const { return {bytes.data(), whole() ? size : 0}; }
};

/// What came of a wait for a packet.
enum class UsbGot {
    packet,
    nothing, ///< within the wait
    lost,    ///< the device is gone and stays so
};

} // namespace tp
