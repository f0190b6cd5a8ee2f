// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/conflicts.hpp"

#include <regex>
#include <string>

namespace tp {

namespace {

/// Longer names do not exist on any file system; std::regex goes as deep as its text is long.
constexpr std::size_t longest_name = 255;

/// What each program puts before the extension, or at the end of a name without one. A person's or machine's
/// name may hold anything but parentheses.
const std::regex& markers() {
    static const std::regex regex(
        // Syncthing: .sync-conflict-20260501-101500-ABCDEFG; before 1.0 without the device
        R"((\.sync-conflict-\d{8}-\d{6}(-[A-Z2-7]{7})?)"
        // ownCloud and Nextcloud before 2.6: _conflict-20260501-101500 and _conflict-Anna-20260501-101500
        R"(|_conflict-([^()]*-)?\d{8}-\d{6})"
        // Nextcloud, OpenCloud: (conflicted copy 2026-05-01 101500), (conflicted copy Anna 2026-05-01
        // 101500); Dropbox: (Anna's conflicted copy 2026-05-01), (conflicted copy 2026-05-01 (1))
        R"(| \(([^()]* )?[Cc]onflicted [Cc]opy( [^()]*)?( ?\(\d+\))?\))"
        // names that differ in nothing but letter case: Nextcloud, Dropbox
        R"(| \([Cc]ase ([Cc]lash from [^()]*|[Cc]onflict( \d+| \(\d+\))?)\))"
        // Seafile: (SFConflict anna@example.org 2026-05-01-10-15-00)
        R"(| \(SFConflict [^()]*\)))"
        R"(( \(\d+\))?(\.[^.]*)?$)",
        std::regex::optimize);
    return regex;
}

} // namespace

std::optional<std::string> conflict_original(std::string_view file_name) {
    if (file_name.size() > longest_name)
        return std::nullopt;
    std::string name(file_name);
    bool found = false;
    for (std::smatch match; std::regex_search(name, match, markers()); found = true) {
        const std::string extension = match[match.size() - 1];
        name = match.prefix().str() + extension;
    }
    return found && !name.empty() ? std::optional(name) : std::nullopt;
}

} // namespace tp
