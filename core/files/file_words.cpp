// SPDX-License-Identifier: Apache-2.0
#include "core/files/file_words.hpp"

#include "core/base/words.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace tp {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD

/// Bytes of the UTF-8 character that `text` begins with; 0 where it begins with none (RFC 3629: shortest
/// form, no surrogates, at most U+10FFFF).
std::size_t character_length(std::string_view text, char32_t& code) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) {
        code = first;
        return 1;
    }
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < length)
        return 0;
    code = first & (0xFFu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0u) != 0x80u)
            return 0;
        code = (code << 6) | (byte(i) & 0x3Fu);
    }
    const char32_t least = length == 2 ? 0x80 : length == 3 ? 0x800 : 0x10000;
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    return code < least || code > 0x10FFFF || surrogate ? 0 : length;
}

/// Not to be shown: controls, line ends, and what turns the direction of the rest of the sentence (Unicode
/// UAX 9).
bool unwelcome(char32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C ||
           (code >= 0x200E && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
           (code >= 0x2066 && code <= 0x2069);
}

} // namespace

std::string readable(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        char32_t code = 0;
        const std::size_t length = character_length(text, code);
        if (length == 0)
            result += replacement;
        else if (unwelcome(code))
            result += ' ';
        else
            result += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

std::string quoted(const std::filesystem::path& path) {
    return tp::quoted(std::string_view(readable(path.string())));
}

std::string reason_of(int error) {
    switch (error) {
    case EACCES:
    case EPERM:
    case EROFS:
        return "you are not allowed to write there.";
    case ENOSPC:
    case EDQUOT:
        return "the disk is full.";
    case EIO:
        return "the disk reports a fault.";
    case ENAMETOOLONG:
        return "its name is too long.";
    case ENOENT:
        return "its folder is gone.";
    case EEXIST:
        return "there is a file of that name already.";
    default:
        return std::generic_category().message(error) + ".";
    }
}

} // namespace tp
