// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/album_lock.hpp"

#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace tp {

Result<AlbumLock> AlbumLock::take(const std::filesystem::path& album) {
    const std::filesystem::path folder = album / ".touchphoto";
    if (const std::string reason = make_folder(folder, Readers::owner_only); !reason.empty())
        return Error{reason};
    const int file = ::open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0)
        return Error{reason_of(errno)};
    AlbumLock lock(file);
    while (::flock(file, LOCK_EX) != 0)
        if (errno != EINTR && errno != ENOLCK && errno != EOPNOTSUPP)
            return Error{reason_of(errno)};
        else if (errno != EINTR)
            break; // a file system without locks, such as some network shares
    return lock;
}

AlbumLock::AlbumLock(AlbumLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

AlbumLock::~AlbumLock() {
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

} // namespace tp
