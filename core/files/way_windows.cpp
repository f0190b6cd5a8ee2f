// SPDX-License-Identifier: Apache-2.0
#include "core/files/way_windows.hpp"

#include "core/files/foreign_folder.hpp"

#include <cerrno>
#include <windows.h>

namespace tp {

namespace fs = std::filesystem;

Way::Way(const fs::path& file) : path_(file) {
    const auto place = foreign_place(file);
    if (!place)
        return;
    foreign_ = true;
    path_ = place->folder / place->below;
    fs::path here = place->folder;
    for (const fs::path& name : place->below.parent_path()) {
        here /= name;
        // To list it, because Windows heeds no sharing of who only looks at attributes.
        const SystemFile& folder = held_.emplace_back(
            CreateFileW(here.c_str(), FILE_LIST_DIRECTORY, FILE_SHARE_READ | FILE_SHARE_WRITE, nullptr,
                        OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS | FILE_FLAG_OPEN_REPARSE_POINT, nullptr));
        if (!folder.ok()) {
            error_ = errno_of_last();
            return;
        }
        const auto facts = facts_of_handle(folder.get());
        if (!facts || facts->kind != FileFacts::Kind::folder) {
            error_ = facts && facts->kind == FileFacts::Kind::link ? ELOOP : ENOTDIR;
            return;
        }
    }
}

int Way::refused() const {
    if (error_ != 0 || !foreign_)
        return error_;
    const SystemFile opened(CreateFileW(path_.c_str(), FILE_READ_ATTRIBUTES, shared_with_all, nullptr,
                                        OPEN_EXISTING,
                                        FILE_FLAG_BACKUP_SEMANTICS | FILE_FLAG_OPEN_REPARSE_POINT, nullptr));
    const auto facts = opened.ok() ? facts_of_handle(opened.get()) : std::nullopt;
    return facts && facts->kind == FileFacts::Kind::link ? ELOOP : 0;
}

} // namespace tp
