// SPDX-License-Identifier: Apache-2.0
#include "core/base/windows/overlapped_io.hpp"
#include "core/base/windows/wide_text.hpp"
#include "device/haply_2diy/serial_port.hpp"
#include "device/open_problem.hpp"

#include <algorithm>
#include <utility>

namespace tp {

namespace {

/// Bytes as they are; no flow control, and the modem lines on, without which some boards send nothing. The
/// rate means nothing on a USB port of its own; 1200 would send an Arduino into its boot loader.
bool make_raw(HANDLE port) {
    DCB settings{};
    settings.DCBlength = sizeof settings;
    if (GetCommState(port, &settings) == 0)
        return false;
    settings = {};
    settings.DCBlength = sizeof settings;
    settings.BaudRate = CBR_115200;
    settings.fBinary = TRUE;
    settings.ByteSize = 8;
    settings.Parity = NOPARITY;
    settings.StopBits = ONESTOPBIT;
    settings.fDtrControl = DTR_CONTROL_ENABLE;
    settings.fRtsControl = RTS_CONTROL_ENABLE;
    COMMTIMEOUTS none{}; // a request ends when it is full, or is given up
    return SetCommState(port, &settings) != 0 && SetCommTimeouts(port, &none) != 0;
}

OpenProblem problem_of(DWORD error) {
    switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_DEV_NOT_EXIST:
        return OpenProblem::gone;
    case ERROR_ACCESS_DENIED: // another program has it open
    case ERROR_SHARING_VIOLATION:
        return OpenProblem::serial_permission;
    default:
        return OpenProblem::other;
    }
}

class WindowsSerialPort final : public SerialPort {
public:
    explicit WindowsSerialPort(windows::Handle port) : port_(std::move(port)) {}

    int read(std::span<std::uint8_t> into, int wait_ms) noexcept override {
        return windows::read_serial(port_.get(), into, static_cast<DWORD>(std::max(0, wait_ms)));
    }
    bool write(std::span<const std::uint8_t> bytes) noexcept override {
        constexpr DWORD patience_ms = 1000;
        return windows::write_all(port_.get(), bytes, patience_ms);
    }
    SystemHandle handle() const override { return reinterpret_cast<SystemHandle>(port_.get()); }

private:
    windows::Handle port_;
};

} // namespace

Result<std::unique_ptr<SerialPort>> open_serial_port(const std::string& path, const std::string& name) {
    const std::string device = path.starts_with("\\\\") ? path : "\\\\.\\" + path; // COM10 has no other name
    windows::Handle port(CreateFileW(windows::wide(device).c_str(), GENERIC_READ | GENERIC_WRITE, 0, nullptr,
                                     OPEN_EXISTING, FILE_FLAG_OVERLAPPED, nullptr));
    if (!port)
        return Error{sentence(problem_of(GetLastError()), this_system(), name)};
    if (!make_raw(port.get()))
        return Error{sentence(OpenProblem::other, this_system(), name)};
    PurgeComm(port.get(), PURGE_RXCLEAR | PURGE_TXCLEAR);
    return std::unique_ptr<SerialPort>(std::make_unique<WindowsSerialPort>(std::move(port)));
}

} // namespace tp
