// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/files/open_file.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// What has a name in a folder.
struct FolderEntry {
    std::string name;
    FileFacts facts; ///< of what it leads to
    bool link = false; ///< in a ForeignFolder the facts are the link's own then
};

/// A folder held open, so that all that is asked is asked of the same one. It closes itself.
class OpenFolder {
public:
    /// Not `ok`, and `errno`, where it could not be opened.
    explicit OpenFolder(const std::filesystem::path& folder);
    OpenFolder(OpenFolder&&) noexcept;
    ~OpenFolder();

    bool ok() const { return system_ != nullptr; }
    std::optional<FileFacts> facts() const;
    /// Whether it is what the kernel shows of itself, as all in /proc and /sys is.
    bool is_of_kernel() const;
    /// Those whose name is `wanted`, in the order of their names' bytes; not what has just gone, nor links to nothing,
    /// but in a ForeignFolder or where `all_links` are wanted. Where
    /// the system would not tell all, its number is in `error`, else 0. To be called once.
    std::vector<FolderEntry> entries(const std::function<bool(std::string_view name)>& wanted, int& error,
                                     bool all_links = false) const;

private:
    struct System;
    std::unique_ptr<System> system_;
};

/// Now, by the clock that the system stamps files with, which may stand still for some milliseconds; in ns since 1970.
std::int64_t file_clock_ns();

} // namespace tp
