// SPDX-License-Identifier: Apache-2.0
#include "core/files/facts_posix.hpp"
#include "core/files/file_words.hpp"
#include "core/files/foreign_folder.hpp"
#include "core/files/open_folder.hpp"
#include "core/files/way_posix.hpp"

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <dirent.h>
#include <fcntl.h>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace tp {

struct OpenFolder::System {
    DIR* folder;
    bool foreign; ///< what is in it
};

OpenFolder::OpenFolder(const std::filesystem::path& folder) {
    const Way way(folder);
    if (way.error() != 0) {
        errno = way.error();
        return;
    }
    const int links = way.foreign() ? O_NOFOLLOW : 0;
    const int number =
        ::openat(way.folder(), way.name(), O_RDONLY | O_DIRECTORY | O_NONBLOCK | O_CLOEXEC | links);
    if (number < 0) {
        const int error = errno;
        errno = way.refused() == ELOOP ? ELOOP : error;
        return;
    }
    const bool foreign = way.foreign() || foreign_place(folder / "name").has_value();
    if (DIR* const opened = ::fdopendir(number); opened != nullptr) {
        system_ = std::make_unique<System>(System{opened, foreign});
        return;
    }
    const int error = errno;
    ::close(number);
    errno = error;
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

bool OpenFolder::is_of_kernel() const { return is_kernels(::dirfd(system_->folder)); }

std::vector<FolderEntry> OpenFolder::entries(const std::function<bool(std::string_view)>& wanted, int& error,
                                             bool all_links) const {
    std::vector<FolderEntry> entries;
    const int folder = ::dirfd(system_->folder);
    int fault = 0;
    errno = 0;
    // NOLINTNEXTLINE(concurrency-mt-unsafe): no other thread reads this stream
    while (const dirent* item = ::readdir(system_->folder)) {
        struct stat about {};
        const std::string_view name = item->d_name;
        if (name == "." || name == ".." || !wanted(name))
            continue;
        if (::fstatat(folder, item->d_name, &about, AT_SYMLINK_NOFOLLOW) == 0) {
            const bool link = S_ISLNK(about.st_mode);
            const bool followed =
                link && !system_->foreign && ::fstatat(folder, item->d_name, &about, 0) == 0;
            if (!link || followed || system_->foreign || all_links)
                entries.push_back({item->d_name, facts_from(about), link});
        } else if (is_disks_fault(errno)) {
            fault = errno;
        }
        errno = 0; // a link to nothing, or a file that has just gone
    }
    error = errno != 0 ? errno : fault;
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
