// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "device/haply_2diy/serial_line.hpp"

#include <memory>
#include <string>

namespace tp {

/// A serial port of Linux or macOS that carries bytes as they are; no other program can open it meanwhile.
class PosixSerial final : public SerialLine {
public:
    /// The error says what to do for a device called `name`. On Windows always an error.
    static Result<std::unique_ptr<PosixSerial>> open(const std::string& path, const std::string& name);
    ~PosixSerial() override;
    PosixSerial(const PosixSerial&) = delete;
    PosixSerial& operator=(const PosixSerial&) = delete;

    int read(std::span<std::uint8_t> into, int wait_ms) noexcept override;
    /// Gives up, as on a line that is gone, when nothing moves for a second.
    bool write(std::span<const std::uint8_t> bytes) noexcept override;
    int descriptor() const { return descriptor_; }

private:
    explicit PosixSerial(int descriptor) : descriptor_(descriptor) {}
    int descriptor_;
};

} // namespace tp
