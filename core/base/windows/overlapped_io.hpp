// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <windows.h>

/// Reading and writing with a limit in time on files that were opened with FILE_FLAG_OVERLAPPED.
namespace tp::windows {

/// A handle that closes itself.
class Handle {
public:
    Handle() = default;
    explicit Handle(HANDLE handle) : handle_(handle == INVALID_HANDLE_VALUE ? nullptr : handle) {}
    ~Handle() { reset(); }
    Handle(Handle&& other) noexcept : handle_(other.release()) {}
    Handle& operator=(Handle&& other) noexcept {
        reset();
        handle_ = other.release();
        return *this;
    }
    HANDLE get() const { return handle_; }
    explicit operator bool() const { return handle_ != nullptr; }
    /// It is the caller's to close.
    HANDLE release() { return std::exchange(handle_, nullptr); }
    void reset() {
        if (handle_ != nullptr)
            CloseHandle(handle_);
        handle_ = nullptr;
    }

private:
    HANDLE handle_ = nullptr;
};

/// How many bytes came, 0 where none did within `wait_ms` (INFINITE: however long that takes), −1 where the
/// file is gone. A read that is given up loses nothing.
int read_some(HANDLE file, std::span<std::uint8_t> into, DWORD wait_ms) noexcept;

/// The same for a serial port, whose reads by themselves end only when they are full.
int read_serial(HANDLE port, std::span<std::uint8_t> into, DWORD wait_ms) noexcept;

/// How many bytes were taken within `wait_ms`; −1 where the file is gone.
int write_some(HANDLE file, std::span<const std::uint8_t> bytes, DWORD wait_ms) noexcept;

/// All of it; false where the file is gone or takes nothing for `patience_ms`.
bool write_all(HANDLE file, std::span<const std::uint8_t> bytes, DWORD patience_ms) noexcept;

} // namespace tp::windows
