// SPDX-License-Identifier: Apache-2.0
#include "core/files/file_system.hpp"
#include "core/files/foreign_folder.hpp"
#include "core/files/open_folder.hpp"
#include "core/files/way_windows.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>
#include <windows.h>

namespace tp {

namespace fs = std::filesystem;

struct OpenFolder::System {
    fs::path folder;
    SystemFile opened; ///< so that it stays where it is
    bool foreign;      ///< what is in it
};

OpenFolder::OpenFolder(const fs::path& folder) {
    const Way way(folder);
    if (way.error() != 0) {
        errno = way.error();
        return;
    }
    const HANDLE opened =
        CreateFileW(way.path().c_str(), FILE_LIST_DIRECTORY, FILE_SHARE_READ | FILE_SHARE_WRITE, nullptr,
                    OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS | way.no_links(), nullptr);
    if (opened == INVALID_HANDLE_VALUE) {
        errno_of_last();
        return;
    }
    system_.reset(
        new System{folder, SystemFile(opened), way.foreign() || foreign_place(folder / "name").has_value()});
    if (const auto is = facts(); !is || is->kind != FileFacts::Kind::folder) {
        const bool link = is && is->kind == FileFacts::Kind::link;
        system_.reset();
        errno = link ? ELOOP : ENOTDIR;
    }
}

OpenFolder::OpenFolder(OpenFolder&&) noexcept = default;

OpenFolder::~OpenFolder() = default;

std::optional<FileFacts> OpenFolder::facts() const { return facts_of_handle(system_->opened.get()); }

bool OpenFolder::is_of_kernel() const { return false; }

std::vector<FolderEntry> OpenFolder::entries(const std::function<bool(std::string_view)>& wanted, int& error,
                                             bool all_links) const {
    std::vector<FolderEntry> entries;
    std::error_code problem;
    for (fs::directory_iterator at(system_->folder, problem), end; !problem && at != end;
         at.increment(problem)) {
        std::string name = at->path().filename().string();
        if (!wanted(name))
            continue;
        const auto named = facts_of_name(at->path());
        const bool link = named && named->kind == FileFacts::Kind::link;
        if (const auto facts = link && !system_->foreign
                                   ? facts_of(at->path())
                                   : named) // none: a link to nothing, or a file that has just gone
            entries.push_back({std::move(name), *facts, link});
        else if (named && all_links)
            entries.push_back({std::move(name), *named, link});
    }
    error = problem ? EIO : 0;
    std::ranges::sort(entries, {}, &FolderEntry::name);
    return entries;
}

std::int64_t file_clock_ns() {
    FILETIME now{};
    GetSystemTimeAsFileTime(&now);
    return ns_of(now);
}

} // namespace tp
