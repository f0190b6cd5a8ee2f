// SPDX-License-Identifier: Apache-2.0
#include "core/files/facts_windows.hpp"
#include "core/files/file_system.hpp"
#include "core/files/open_folder.hpp"

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
};

OpenFolder::OpenFolder(const fs::path& folder) {
    const HANDLE opened = CreateFileW(folder.c_str(), FILE_LIST_DIRECTORY, FILE_SHARE_READ | FILE_SHARE_WRITE,
                                      nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
    if (opened == INVALID_HANDLE_VALUE) {
        errno_of_last();
        return;
    }
    system_.reset(new System{folder, SystemFile(opened)});
    if (const auto is = facts(); !is || is->kind != FileFacts::Kind::folder) {
        system_.reset();
        errno = ENOTDIR;
    }
}

OpenFolder::OpenFolder(OpenFolder&&) noexcept = default;

OpenFolder::~OpenFolder() = default;

std::optional<FileFacts> OpenFolder::facts() const { return facts_of_handle(system_->opened.get()); }

std::vector<FolderEntry> OpenFolder::entries(const std::function<bool(std::string_view)>& wanted,
                                             int& error) const {
    std::vector<FolderEntry> entries;
    std::error_code problem;
    for (fs::directory_iterator at(system_->folder, problem), end; !problem && at != end;
         at.increment(problem)) {
        std::string name = at->path().filename().string();
        if (!wanted(name))
            continue;
        const auto named = facts_of_name(at->path());
        const bool link = named && named->kind == FileFacts::Kind::link;
        if (const auto facts =
                link ? facts_of(at->path()) : named) // none: a link to nothing, or a file that has just gone
            entries.push_back({std::move(name), *facts, link});
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
