// SPDX-License-Identifier: Apache-2.0
#include "core/base/windows/overlapped_io.hpp"

#include <algorithm>
#include <cstddef>

namespace tp::windows {

namespace {

/// What became of a request that was begun: bytes, 0 where it was given up, −1 where it failed. It does not
/// go on afterwards, because its buffer may not.
int outcome(HANDLE file, BOOL begun, OVERLAPPED& request, DWORD wait_ms) noexcept {
    if (begun == 0 && GetLastError() != ERROR_IO_PENDING)
        return -1;
    if (begun == 0 && WaitForSingleObject(request.hEvent, wait_ms) != WAIT_OBJECT_0)
        CancelIoEx(file, &request);
    DWORD moved = 0;
    if (GetOverlappedResult(file, &request, &moved, TRUE) == 0)
        return GetLastError() == ERROR_OPERATION_ABORTED ? static_cast<int>(moved) : -1;
    return static_cast<int>(moved);
}

} // namespace

int read_some(HANDLE file, std::span<std::uint8_t> into, DWORD wait_ms) noexcept {
    const Handle done(CreateEventW(nullptr, TRUE, FALSE, nullptr));
    OVERLAPPED request{};
    request.hEvent = done.get();
    const BOOL begun = ReadFile(file, into.data(), static_cast<DWORD>(into.size()), nullptr, &request);
    return outcome(file, begun, request, wait_ms);
}

int read_serial(HANDLE port, std::span<std::uint8_t> into, DWORD wait_ms) noexcept {
    COMSTAT state{};
    DWORD errors = 0;
    if (ClearCommError(port, &errors, &state) == 0)
        return -1;
    if (state.cbInQue == 0 && wait_ms == 0)
        return 0;
    const std::size_t there = std::max<std::size_t>(1, state.cbInQue);
    return read_some(port, into.first(std::min(into.size(), there)), wait_ms);
}

int write_some(HANDLE file, std::span<const std::uint8_t> bytes, DWORD wait_ms) noexcept {
    const Handle done(CreateEventW(nullptr, TRUE, FALSE, nullptr));
    OVERLAPPED request{};
    request.hEvent = done.get();
    const BOOL begun = WriteFile(file, bytes.data(), static_cast<DWORD>(bytes.size()), nullptr, &request);
    return outcome(file, begun, request, wait_ms);
}

bool write_all(HANDLE file, std::span<const std::uint8_t> bytes, DWORD patience_ms) noexcept {
    while (!bytes.empty()) {
        const int taken = write_some(file, bytes, patience_ms);
        if (taken <= 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(taken));
    }
    return true;
}

} // namespace tp::windows
