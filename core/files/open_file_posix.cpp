// SPDX-License-Identifier: Apache-2.0
#include "core/files/facts_posix.hpp"
#include "core/files/open_file.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace tp {

namespace {

int flags_of(const OpenMode& how) {
    int flags = O_CLOEXEC | O_NONBLOCK | O_NOCTTY;
    flags |= !how.write ? O_RDONLY : how.read ? O_RDWR : O_WRONLY;
    flags |= how.make ? O_CREAT : 0;
    flags |= how.only_new ? O_EXCL : 0;
    flags |= how.emptied ? O_TRUNC : 0;
    flags |= how.at_end ? O_APPEND : 0;
    flags |= how.follow_link ? 0 : O_NOFOLLOW;
    return flags;
}

/// `some(done)` reads what follows the `done` bytes. False: a fault; `done` were read before.
template <typename Some>
bool filled(std::size_t size, std::size_t& done, const Some& some) {
    while (done < size) {
        const ssize_t count = some(done);
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            return false;
        if (count == 0)
            break;
        done += static_cast<std::size_t>(count);
    }
    return true;
}

template <typename Some>
Written all_written(std::size_t size, const Some& some) {
    Written written;
    while (written.count < size) {
        const ssize_t count = some(written.count);
        if (count < 0 && errno != EINTR) {
            written.error = errno;
            break;
        }
        if (count > 0)
            written.count += static_cast<std::size_t>(count);
    }
    return written;
}

} // namespace

OpenFile::OpenFile(const std::filesystem::path& file, const OpenMode& how)
    : number_(::open(file.c_str(), flags_of(how), how.readers == Readers::owner_only ? 0600 : 0666)) {}

OpenFile& OpenFile::operator=(OpenFile&& other) noexcept {
    close();
    number_ = other.release();
    return *this;
}

void OpenFile::close() {
    if (ok())
        ::close(release());
}

Descriptor OpenFile::handed_over() { return Descriptor(release()); }

std::optional<FileFacts> OpenFile::facts() const {
    struct stat about {};
    if (::fstat(number_, &about) != 0)
        return std::nullopt;
    return facts_from(about);
}

std::int64_t OpenFile::read(std::span<char> to) {
    std::size_t done = 0;
    const auto some = [&](std::size_t at) { return ::read(number_, to.data() + at, to.size() - at); };
    return filled(to.size(), done, some) ? static_cast<std::int64_t>(done) : -1;
}

std::size_t OpenFile::read_at(std::uint64_t at, std::span<char> to) const {
    return tp::read_at(number_, at, to);
}

Written OpenFile::write(std::string_view bytes) {
    return all_written(bytes.size(), [&](std::size_t done) {
        return ::write(number_, bytes.data() + done, bytes.size() - done);
    });
}

Written OpenFile::write_at(std::uint64_t at, std::string_view bytes) const {
    return all_written(bytes.size(), [&](std::size_t done) {
        return ::pwrite(number_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(at + done));
    });
}

std::int64_t OpenFile::go_to(std::int64_t offset, int from) { return ::lseek(number_, offset, from); }

int OpenFile::cut(std::uint64_t bytes) {
    return ::ftruncate(number_, static_cast<off_t>(bytes)) == 0 ? 0 : errno;
}

int OpenFile::to_disk() const { return ::fsync(number_) == 0 ? 0 : errno; }

int OpenFile::bytes_to_disk() const {
#if defined(__APPLE__)
    return to_disk();
#else
    return ::fdatasync(number_) == 0 ? 0 : errno;
#endif
}

int OpenFile::bytes_out_of_memory() const {
#if defined(__linux__)
    constexpr unsigned all = SYNC_FILE_RANGE_WAIT_BEFORE | SYNC_FILE_RANGE_WRITE | SYNC_FILE_RANGE_WAIT_AFTER;
    const int error = ::sync_file_range(number_, 0, 0, all) == 0 ? 0 : errno;
    return error == EINVAL || error == ENOSYS || error == ESPIPE
               ? 0
               : error; // a file system that keeps it otherwise
#else
    return bytes_to_disk();
#endif
}

void OpenFile::give_readers_of(const std::filesystem::path& other) const {
    struct stat about {};
    if (::stat(other.c_str(), &about) == 0) // where that cannot be kept, the file is still worth writing
        static_cast<void>(::fchmod(number_, about.st_mode & 0777u));
}

bool OpenFile::lock() const { return ::flock(number_, LOCK_EX | LOCK_NB) == 0; }

bool OpenFile::wait_for_lock() const {
    while (::flock(number_, LOCK_EX) != 0)
        if (errno != EINTR)
            return false;
    return true;
}

std::size_t read_at(DescriptorNumber file, std::uint64_t at, std::span<char> to) {
    std::size_t done = 0;
    filled(to.size(), done, [&](std::size_t before) {
        return ::pread(file, to.data() + before, to.size() - before, static_cast<off_t>(at + before));
    });
    return done;
}

} // namespace tp
