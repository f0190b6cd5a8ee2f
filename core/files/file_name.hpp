// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tp {

// Between text and the system's names of files: the same bytes where names are bytes, UTF-16 on Windows, never its code page.

/// The path that text in UTF-8 names.
inline std::filesystem::path path_named(std::string_view utf8) {
    return std::u8string(utf8.begin(), utf8.end());
}

/// A path as UTF-8; where names are bytes, those bytes, which may be none.
inline std::string name_in_utf8(const std::filesystem::path& path) {
    const std::u8string text = path.u8string();
    return {text.begin(), text.end()};
}

} // namespace tp
