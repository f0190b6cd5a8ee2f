// SPDX-License-Identifier: Apache-2.0
#include "core/files/file_words.hpp"

#include "core/base/utf8.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace tp {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD

} // namespace

bool is_unwelcome(char32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C ||
           (code >= 0x200E && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
           (code >= 0x2066 && code <= 0x2069);
}

std::string readable(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        char32_t code = 0;
        const std::size_t length = utf8_length(text, code);
        if (length == 0)
            result += replacement;
        else if (is_unwelcome(code))
            result += ' ';
        else
            result += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

std::string quoted_readable(std::string_view text) { return tp::quoted(std::string_view(readable(text))); }

bool is_disks_fault(int error) {
    switch (error) {
    case EIO:
    case ENODEV:
    case ENOTCONN:
    case ETIMEDOUT:
#if defined(ESTALE) // Windows has none of these
    case ESTALE:
#endif
#if defined(EUCLEAN)
    case EUCLEAN:
#endif
#if defined(EREMOTEIO)
    case EREMOTEIO:
#endif
        return true;
    default:
        return false;
    }
}

std::string reason_of(int error) {
    switch (error) {
    case EACCES:
    case EPERM:
    case EROFS:
        return "you are not allowed to write there.";
    case ENOSPC:
#if defined(EDQUOT) // Windows knows no quota of its own
    case EDQUOT:
#endif
        return "the disk is full.";
    case EIO:
        return "the disk reports a fault.";
    case ENAMETOOLONG:
        return "its name is too long.";
    case ENOENT:
        return "its folder is gone.";
    case EEXIST:
        return "there is a file of that name already.";
    case ELOOP:
        return "it is a link; it is left alone.";
    case EMLINK:
        return "it has another name too, and is not written into.";
    case ENXIO:
        return "it is not a file.";
    default:
        return std::generic_category().message(error) + ".";
    }
}

} // namespace tp
