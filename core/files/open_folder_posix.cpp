// SPDX-License-Identifier: Apache-2.0
#include "core/files/facts_posix.hpp"
#include "core/files/open_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <utility>

namespace tp {

struct OpenFolder::System {
    DIR* folder;
};

OpenFolder::OpenFolder(const std::filesystem::path& folder) {
    if (DIR* const opened = ::opendir(folder.c_str()); opened != nullptr)
        system_ = std::make_unique<System>(System{opened});
}

OpenFolder::OpenFolder(OpenFolder&&) noexcept = default;

OpenFolder::~OpenFolder() {
    if (ok())
        ::closedir(system_->folder);
}

std::optional<FileFacts> OpenFolder::facts() const {
    struct stat about {};
    if (::fstat(::dirfd(system_->folder), &about) != 0)
        return std::nullopt;
    return facts_from(about);
}

std::vector<FolderEntry> OpenFolder::entries(const std::function<bool(std::string_view)>& wanted,
                                             int& error) const {
    std::vector<FolderEntry> entries;
    const int folder = ::dirfd(system_->folder);
    errno = 0;
    // NOLINTNEXTLINE(concurrency-mt-unsafe): no other thread reads this stream
    while (const dirent* item = ::readdir(system_->folder)) {
        struct stat about {};
        if (wanted(item->d_name) && ::fstatat(folder, item->d_name, &about, AT_SYMLINK_NOFOLLOW) == 0) {
            const bool link = S_ISLNK(about.st_mode);
            if (!link || ::fstatat(folder, item->d_name, &about, 0) == 0)
                entries.push_back({item->d_name, facts_from(about), link});
        }
        errno = 0; // a link to nothing, or a file that has just gone
    }
    error = errno;
    std::ranges::sort(entries, {}, &FolderEntry::name);
    return entries;
}

std::int64_t file_clock_ns() {
    timespec now{};
#if defined(__linux__)
    ::clock_gettime(CLOCK_REALTIME_COARSE, &now);
#else
    ::clock_gettime(CLOCK_REALTIME, &now);
#endif
    return ns_of(now);
}

} // namespace tp
