// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <sys/stat.h>

namespace tp {

/// How the system is told of a name. One below a ForeignFolder is told as a name in its folder, which is held open and was reached
/// without following a link; who swaps a folder for a link meanwhile changes nothing. Every other one is told as it is.
class Way {
public:
    explicit Way(const std::filesystem::path& file);
    Way(const Way&) = delete;
    Way& operator=(const Way&) = delete;
    ~Way();

    /// 0, or the system's: there is no such way, or a link lies on it (ELOOP).
    int error() const { return error_; }
    bool foreign() const { return foreign_; }
    /// For the system's calls that take a folder and a name in it.
    int folder() const { return folder_; }
    const char* name() const { return name_.c_str(); }
    /// AT_SYMLINK_NOFOLLOW where a link is not followed, else 0.
    int no_links() const;
    /// What has the name, be it a link; none, and `errno`, where nothing has.
    std::optional<struct stat> stat_of_name() const;
    /// ELOOP where it is foreign and a link has the name now, or `error()`.
    int refused() const;

private:
    std::string name_;
    int folder_;
    int error_ = 0;
    bool foreign_ = false;
};

} // namespace tp
