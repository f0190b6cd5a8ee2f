// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/conflicts.hpp"

#include <algorithm>
#include <cctype>

namespace tp {

namespace {

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// "20260501-101500"
bool is_stamp(std::string_view text) {
    return text.size() == 15 && text[8] == '-' && std::all_of(text.begin(), text.begin() + 8, is_digit) &&
           std::all_of(text.begin() + 9, text.end(), is_digit);
}

/// Syncthing: ".sync-conflict-20260501-101500-ABCDEFG"; before 1.0 without the device.
bool is_syncthing(std::string_view rest) {
    constexpr std::size_t stamp = 15;
    constexpr std::size_t device = 7;
    return is_stamp(rest.substr(0, stamp)) &&
           (rest.size() == stamp || (rest.size() == stamp + 1 + device && rest[stamp] == '-'));
}

/// ownCloud, and Nextcloud before 2.6: "_conflict-20260501-101500", "_conflict-Anna-20260501-101500".
bool is_owncloud(std::string_view rest) {
    constexpr std::size_t stamp = 15;
    return rest.size() >= stamp && is_stamp(rest.substr(rest.size() - stamp)) &&
           (rest.size() == stamp || rest[rest.size() - stamp - 1] == '-');
}

/// Nextcloud and OpenCloud "conflicted copy Anna 2026-05-01 101500", Dropbox "Anna's conflicted copy
/// 2026-05-01 (1)", both for names that differ in letter case alone, Seafile "SFConflict anna@example.org …".
bool is_remark(std::string_view inside) {
    std::string text(inside);
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text.find("conflicted copy") != std::string::npos || text.starts_with("case clash from ") ||
           text.starts_with("case conflict") || text.starts_with("sfconflict ");
}

/// Where the parenthesis opens that closes at the end of the text; npos where none does.
std::size_t opening(std::string_view text) {
    int depth = 0;
    for (std::size_t i = text.size(); i-- > 0;) {
        depth += text[i] == ')' ? 1 : text[i] == '(' ? -1 : 0;
        if (depth == 0)
            return text[i] == '(' ? i : std::string_view::npos;
    }
    return std::string_view::npos;
}

/// What stands before the mark that a sync program put at the end of a name.
std::optional<std::string_view> before_mark(std::string_view stem) {
    constexpr std::string_view syncthing = ".sync-conflict-";
    constexpr std::string_view owncloud = "_conflict-";
    if (const std::size_t at = stem.rfind(syncthing);
        at != std::string_view::npos && is_syncthing(stem.substr(at + syncthing.size())))
        return stem.substr(0, at);
    if (const std::size_t at = stem.rfind(owncloud);
        at != std::string_view::npos && is_owncloud(stem.substr(at + owncloud.size())))
        return stem.substr(0, at);
    const std::size_t open = opening(stem);
    if (open == std::string_view::npos || open == 0 || stem[open - 1] != ' ')
        return std::nullopt;
    const std::string_view inside = stem.substr(open + 1, stem.size() - open - 2);
    const std::string_view rest = stem.substr(0, open - 1);
    if (is_remark(inside))
        return rest;
    const bool counts = !inside.empty() && std::all_of(inside.begin(), inside.end(), is_digit);
    return counts ? before_mark(rest) : std::nullopt; // "… (conflicted copy) (2)"
}

/// The name without one mark, which stands before the extension or, without one, at its end.
std::optional<std::string> without_mark(std::string_view name) {
    if (const auto whole = before_mark(name))
        return std::string(*whole);
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos)
        return std::nullopt;
    const auto stem = before_mark(name.substr(0, dot));
    return stem ? std::optional(std::string(*stem).append(name.substr(dot))) : std::nullopt;
}

} // namespace

std::optional<std::string> conflict_original(std::string_view file_name) {
    std::optional<std::string> original = without_mark(file_name);
    while (original)
        if (auto earlier = without_mark(*original))
            original = std::move(earlier);
        else
            break;
    return original && !original->empty() ? original : std::nullopt;
}

} // namespace tp
