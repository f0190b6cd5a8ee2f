// SPDX-License-Identifier: Apache-2.0
#include "core/base/windows/wide_text.hpp"

#include <windows.h>

namespace tp::windows {

std::wstring wide(std::string_view text) {
    const int size = static_cast<int>(text.size());
    std::wstring made(
        static_cast<std::size_t>(MultiByteToWideChar(CP_UTF8, 0, text.data(), size, nullptr, 0)), L'\0');
    MultiByteToWideChar(CP_UTF8, 0, text.data(), size, made.data(), static_cast<int>(made.size()));
    return made;
}

std::string narrow(std::wstring_view text) {
    const int size = static_cast<int>(text.size());
    std::string made(static_cast<std::size_t>(
                         WideCharToMultiByte(CP_UTF8, 0, text.data(), size, nullptr, 0, nullptr, nullptr)),
                     '\0');
    WideCharToMultiByte(CP_UTF8, 0, text.data(), size, made.data(), static_cast<int>(made.size()), nullptr,
                        nullptr);
    return made;
}

} // namespace tp::windows
