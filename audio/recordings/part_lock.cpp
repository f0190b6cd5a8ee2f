// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/part_lock.hpp"

#include "core/files/file_words.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace tp {

Result<std::optional<PartLock>> PartLock::take(const std::filesystem::path& part) {
    const int descriptor = ::open(part.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW);
    if (descriptor < 0 && errno == ENOENT)
        return std::optional<PartLock>();
    if (descriptor < 0)
        return Error{errno == EISDIR || errno == ELOOP || errno == ENXIO ? "it is not a file."
                                                                         : reason_of(errno)};
    PartLock lock(descriptor);
    struct stat open_one {};
    if (::fstat(descriptor, &open_one) != 0 || !S_ISREG(open_one.st_mode))
        return Error{"it is not a file."};
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        if (errno == EWOULDBLOCK)
            return std::optional<PartLock>();
        return Error{reason_of(errno)};
    }
    struct stat named_one {}; // who held it before may have taken it away meanwhile
    if (::lstat(part.c_str(), &named_one) != 0 || named_one.st_ino != open_one.st_ino ||
        named_one.st_dev != open_one.st_dev)
        return std::optional<PartLock>();
    return std::optional<PartLock>(std::move(lock));
}

PartLock::PartLock(PartLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

PartLock::~PartLock() {
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

} // namespace tp
