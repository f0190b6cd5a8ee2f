// SPDX-License-Identifier: Apache-2.0
#include "core/base/windows/overlapped_io.hpp"
#include "device/guard/process/ends.hpp"

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace tp::guard {

namespace {

constexpr DWORD patience_ms = 2000;

HANDLE ends[2] = {nullptr, nullptr};

HANDLE handle_of(End end) { return ends[static_cast<std::size_t>(end)]; }

/// What core/processes has started this process with: the handles' numbers.
bool take(const char* numbers) {
    if (numbers == nullptr)
        return false;
    std::string_view rest(numbers);
    for (HANDLE& end : ends) {
        std::intptr_t number = 0;
        const char* const behind = std::from_chars(rest.data(), rest.data() + rest.size(), number).ptr;
        if (behind == rest.data() || *behind != ' ')
            return false;
        rest.remove_prefix(static_cast<std::size_t>(behind + 1 - rest.data()));
        end = reinterpret_cast<HANDLE>(number);
    }
    return true;
}

} // namespace

bool take_ends() {
    SetConsoleCtrlHandler(nullptr, TRUE); // Ctrl-C is not for it
    return take(std::getenv("TOUCHPHOTO_GIVEN"));
}

int read_within(End end, std::span<std::uint8_t> into, int wait_ms) {
    const DWORD wait = wait_ms < 0 ? INFINITE : static_cast<DWORD>(wait_ms);
    return end == End::device ? windows::read_serial(handle_of(end), into, wait)
                              : windows::read_some(handle_of(end), into, wait);
}

bool write_all(End end, std::span<const std::uint8_t> bytes) {
    return windows::write_all(handle_of(end), bytes, patience_ms);
}

} // namespace tp::guard
