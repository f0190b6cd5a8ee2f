// SPDX-License-Identifier: Apache-2.0
#include "device/guard/process/ends.hpp"
#include "core/base/windows/overlapped_io.hpp"

#include <charconv>
#include <cstdint>
#include <string_view>

namespace tp::guard {

namespace {

constexpr DWORD patience_ms = 2000;

HANDLE ends[2] = {nullptr, nullptr};

HANDLE handle_of(End end) { return ends[static_cast<std::size_t>(end)]; }

/// The first words are the handles that it inherits, as numbers.
bool take(std::span<char*>& words, HANDLE& into) {
    if (words.empty())
        return false;
    const std::string_view word(words.front());
    std::intptr_t number = 0;
    if (std::from_chars(word.data(), word.data() + word.size(), number).ptr != word.data() + word.size())
        return false;
    words = words.subspan(1);
    into = reinterpret_cast<HANDLE>(number);
    return true;
}

} // namespace

bool take_ends(std::span<char*>& words) {
    SetConsoleCtrlHandler(nullptr, TRUE); // Ctrl-C is not for it
    return take(words, ends[0]) && take(words, ends[1]);
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
