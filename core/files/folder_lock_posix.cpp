// SPDX-License-Identifier: Apache-2.0
#include "core/files/folder_lock.hpp"
#include "core/files/way_posix.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

namespace tp {

FolderLock::FolderLock(const std::filesystem::path& folder, std::chrono::milliseconds patience) {
    if (const Way way(folder.empty() ? std::filesystem::path(".") : folder); way.error() == 0)
        descriptor_ = ::openat(way.folder(), way.name(),
                               O_RDONLY | O_DIRECTORY | O_CLOEXEC | (way.foreign() ? O_NOFOLLOW : 0));
    if (descriptor_ < 0) { // a folder that may be written to and not read, or none: writing will tell
        held_ = true;
        return;
    }
    constexpr std::chrono::milliseconds pause(2);
    const auto end = std::chrono::steady_clock::now() + patience;
    while (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
        if (errno == EINTR)
            continue;
        if (errno != EWOULDBLOCK)
            break;
        if (std::chrono::steady_clock::now() >= end)
            return;
        std::this_thread::sleep_for(pause);
    }
    held_ = true;
}

FolderLock::~FolderLock() {
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

} // namespace tp
