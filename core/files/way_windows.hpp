// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/files/facts_windows.hpp"

#include <deque>
#include <filesystem>

namespace tp {

/// How Windows is told of a name. On the way to one below a ForeignFolder each folder is looked at and held open, so that nobody
/// gives it another name or puts a link (a symbolic link, a junction) in its place while this lives; the name itself is then
/// opened as what it is (FILE_FLAG_OPEN_REPARSE_POINT). Every other name is told as it is.
class Way {
public:
    explicit Way(const std::filesystem::path& file);

    /// 0, or: there is no such way, or a link lies on it (ELOOP).
    int error() const { return error_; }
    bool foreign() const { return foreign_; }
    const std::filesystem::path& path() const { return path_; }
    /// For CreateFile: 0 where links are followed.
    DWORD no_links() const { return foreign_ ? FILE_FLAG_OPEN_REPARSE_POINT : 0; }
    /// ELOOP where it is foreign and a link has the name now, or `error()`.
    int refused() const;

private:
    std::filesystem::path path_;
    std::deque<SystemFile> held_;
    int error_ = 0;
    bool foreign_ = false;
};

} // namespace tp
