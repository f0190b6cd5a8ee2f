// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace tp {

/// Bytes to and from a board. One thread reads while another writes.
class SerialLine {
public:
    virtual ~SerialLine() = default;
    /// How many bytes came, 0 where none did within `wait_ms` (0: does not wait at all), −1 where the line is
    /// gone.
    virtual int read(std::span<std::uint8_t> into, int wait_ms) noexcept = 0;
    /// All of it; false where the line is gone. May block for as long as the system likes.
    virtual bool write(std::span<const std::uint8_t> bytes) noexcept = 0;
};

} // namespace tp
