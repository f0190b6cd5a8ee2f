// SPDX-License-Identifier: Apache-2.0
#include "core/files/facts_posix.hpp"
#include "core/files/file_system.hpp"
#include "core/files/open_file.hpp"
#include "core/files/way_posix.hpp"

#include <cerrno>
#include <fcntl.h>
#include <string>
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

/// Before a foreign name is opened, which alone may do something to a device. 0: it may be.
int why_not_opened(const Way& way, bool links, bool make) {
    struct stat about {};
    if (::fstatat(way.folder(), way.name(), &about, links ? 0 : AT_SYMLINK_NOFOLLOW) != 0)
        return errno == ENOENT && make ? 0 : errno;
    if (S_ISLNK(about.st_mode))
        return ELOOP;
    return S_ISREG(about.st_mode) || S_ISDIR(about.st_mode) ? 0 : ENXIO;
}

/// Of a foreign name that was opened, which somebody may have changed at that moment. 0: it may be used.
int why_not_used(int file, const OpenMode& how) {
    struct stat about {};
    if (::fstat(file, &about) != 0)
        return errno;
    if (!S_ISREG(about.st_mode) && !S_ISDIR(about.st_mode))
        return ENXIO;
    if (is_kernels(file))
        return ENXIO;
    if (how.write && S_ISREG(about.st_mode) && about.st_nlink > 1)
        return EMLINK;
    return how.emptied && ::ftruncate(file, 0) != 0 ? errno : 0;
}

} // namespace

OpenFile::OpenFile(const std::filesystem::path& file, const OpenMode& how) {
    const Way way(file);
    const bool links = how.follow_link && (!way.foreign() || (how.looked_at && !how.write));
    int error = way.error();
    if (error == 0 && way.foreign())
        error = why_not_opened(way, links, how.make);
    if (error != 0) {
        errno = error;
        return;
    }
    const bool is_private =
        how.make && how.readers == Readers::owner_only && !names_its_readers(file.parent_path());
    const int flags = flags_of(how) & ~(way.foreign() ? O_TRUNC : 0); // emptied when it is known to be ours
    number_ = ::openat(way.folder(), way.name(), flags | (links ? 0 : O_NOFOLLOW), is_private ? 0600 : 0666);
    if (ok() && way.foreign())
        error = why_not_used(number_, how);
    if (error != 0) {
        close();
        errno = error;
    }
}

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

std::filesystem::path OpenFile::name_of_opened() const {
#if defined(__linux__)
    const std::string name = "/proc/self/fd/" + std::to_string(number_);
    if (ok() && ::access(name.c_str(), R_OK) == 0) // a system without /proc
        return name;
#endif
    return {};
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
    const Way way(other);
    struct stat about {};
    if (way.error() == 0 && ::fstatat(way.folder(), way.name(), &about, way.no_links()) == 0 &&
        !S_ISLNK(about.st_mode)) // where that cannot be kept, the file is still worth writing
        static_cast<void>(::fchmod(number_, about.st_mode & 0777u));
}

void OpenFile::no_more_open_than(const std::filesystem::path& other) const {
    const Way way(other);
    struct stat own {
    }, its{};
    if (way.error() != 0 || ::fstatat(way.folder(), way.name(), &its, way.no_links()) != 0 ||
        S_ISLNK(its.st_mode) || ::fstat(number_, &own) != 0)
        return;
    if (const mode_t narrowed = own.st_mode & (its.st_mode | 0600u) & 0777u;
        narrowed != (own.st_mode & 0777u))
        static_cast<void>(
            ::fchmod(number_, narrowed)); // a file system without rights shows all of them alike
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
    if (filled(to.size(), done, [&](std::size_t before) {
            return ::pread(file, to.data() + before, to.size() - before, static_cast<off_t>(at + before));
        }))
        errno = 0;
    return done;
}

} // namespace tp
