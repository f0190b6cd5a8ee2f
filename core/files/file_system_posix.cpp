// SPDX-License-Identifier: Apache-2.0
#include "core/files/facts_posix.hpp"
#include "core/files/file_system.hpp"
#include "core/files/way_posix.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/wait.h>
#if defined(__linux__)
#include <linux/magic.h>
#include <sys/vfs.h>
#include <sys/xattr.h>
#endif
#include <unistd.h>
#include <utility>
#include <vector>

#if defined(__GLIBC__)
#if __GLIBC_PREREQ(2, 34)
#define TP_CAN_LEAVE_PROCESS // _Fork, which waits for nobody's locks, and close_range
#endif
#endif

namespace tp {

namespace fs = std::filesystem;

namespace {

enum class Rename { to_free, swap };

/// 0, or the system's error: EINVAL or ENOSYS where it, or the file system, knows no such renaming.
int renamed(const Way& from, const Way& to, Rename how) {
#if defined(__linux__)
    const unsigned flag = how == Rename::swap ? RENAME_EXCHANGE : RENAME_NOREPLACE;
    return ::renameat2(from.folder(), from.name(), to.folder(), to.name(), flag) == 0 ? 0 : errno;
#elif defined(__APPLE__)
    const unsigned flag = how == Rename::swap ? RENAME_SWAP : RENAME_EXCL;
    const int error =
        ::renameatx_np(from.folder(), from.name(), to.folder(), to.name(), flag) == 0 ? 0 : errno;
    return error == ENOTSUP ? ENOSYS : error;
#else
    static_cast<void>(from), static_cast<void>(to), static_cast<void>(how);
    return ENOSYS;
#endif
}

/// 0, or why a name is not given, or not taken: foreign links stay what they are.
int refused(const Way& from, const Way& to) {
    const int error = from.refused();
    return error != 0 ? error : to.refused();
}

#if defined(TP_CAN_LEAVE_PROCESS)
std::vector<OpenFile> large_ones(const std::vector<fs::path>& files) {
    constexpr std::int64_t large = 64 << 20; // bytes on the disk
    std::vector<OpenFile> opened;
    for (const fs::path& file : files) {
        OpenFile one(file, {});
        struct stat about {};
        if (one.ok() && ::fstat(one.number(), &about) == 0 && std::int64_t{about.st_blocks} * 512 >= large)
            opened.push_back(std::move(one));
    }
    return opened;
}

/// In the process that is left behind, which may do no more than a signal handler. What it does not hold is closed: whoever reads
/// what the other one wrote, or waits for its locks, does not wait for this one.
[[noreturn]] void hold(const std::vector<int>& held, int alive) {
    unsigned from = 0;
    for (const int file : held) {
        const auto number = static_cast<unsigned>(file);
        if (number > from)
            ::close_range(from, number - 1, 0);
        from = number + 1;
    }
    ::close_range(from, ~0U, 0);
    char none = 0;
    while (::read(alive, &none, 1) < 0 && errno == EINTR) {
    }
    ::_exit(0);
}
#endif

bool unknown(int error) { return error == EINVAL || error == ENOSYS; }

/// FAT, exFAT and many a FUSE have no second names for a file.
bool knows_no_links(int error) {
    return error == EPERM || error == ENOSYS || error == EOPNOTSUPP || error == ENOTSUP || error == EMLINK;
}

#if defined(__linux__)
/// Of FAT, exFAT and Windows' shares the mount says for all files alike who may read them; so do drivers in programs (FUSE) that
/// show all rights of everything, as that of NTFS does.
bool has_no_rights(int folder) {
    constexpr std::array<std::uint32_t, 4> such{MSDOS_SUPER_MAGIC, 0x2011BAB0 /* exFAT */,
                                                0xFF534D42 /* CIFS */, 0xFE534D42 /* SMB 2 */};
    struct statfs disk {};
    struct stat about {};
    if (::fstatfs(folder, &disk) != 0 || ::fstat(folder, &about) != 0)
        return false;
    const auto type = static_cast<std::uint32_t>(disk.f_type);
    return std::find(such.begin(), such.end(), type) != such.end() ||
           (type == FUSE_SUPER_MAGIC && (about.st_mode & 0777u) == 0777u);
}
#endif

/// Where a file system can do it in no one step: takes the free name with something empty, which nobody else can do meanwhile, and
/// gives what is renamed its place.
int renamed_over_claim(const Way& from, const Way& to) {
    const auto about = from.stat_of_name();
    if (!about)
        return errno;
    const bool folder = S_ISDIR(about->st_mode);
    const int claimed =
        folder ? ::mkdirat(to.folder(), to.name(), 0700)
               : ::openat(to.folder(), to.name(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (claimed < 0)
        return errno;
    const OpenFile empty(folder ? -1 : claimed);
    if (::renameat(from.folder(), from.name(), to.folder(), to.name()) == 0)
        return 0;
    const int error = errno;
    ::unlinkat(to.folder(), to.name(), folder ? AT_REMOVEDIR : 0);
    return error;
}

} // namespace

std::optional<FileFacts> facts_of(const fs::path& file) {
    const Way way(file);
    struct stat about {};
    if (way.error() != 0)
        errno = way.error();
    if (way.error() != 0 || ::fstatat(way.folder(), way.name(), &about, way.no_links()) != 0)
        return std::nullopt;
    return facts_from(about);
}

std::optional<FileFacts> facts_of_name(const fs::path& file) {
    const auto about = Way(file).stat_of_name();
    return about ? std::optional(facts_from(*about)) : std::nullopt;
}

std::optional<FileFacts> facts_of_photo(const fs::path& file) {
    const Way way(file);
    struct stat about {};
    if (way.error() != 0)
        errno = way.error();
    if (way.error() != 0 || ::fstatat(way.folder(), way.name(), &about, 0) != 0)
        return std::nullopt;
    return facts_from(about);
}

int rename_over(const fs::path& from, const fs::path& to) {
    const Way one(from), other(to);
    if (const int error = refused(one, other); error != 0)
        return error;
    return ::renameat(one.folder(), one.name(), other.folder(), other.name()) == 0 ? 0 : errno;
}

int rename_to_free(const fs::path& from, const fs::path& to) {
    const Way one(from), other(to);
    if (const int error = one.refused(); error != 0)
        return error;
    if (other.error() != 0)
        return other.error();
    const int error = renamed(one, other, Rename::to_free);
    if (!unknown(error))
        return error;
    if (::linkat(one.folder(), one.name(), other.folder(), other.name(), 0) != 0)
        return knows_no_links(errno) ? renamed_over_claim(one, other) : errno;
    ::unlinkat(one.folder(), one.name(), 0);
    return 0;
}

int move_to_free(const fs::path& from, const fs::path& to) {
    const Way one(from), other(to);
    if (const int error = one.refused(); error != 0)
        return error;
    if (other.error() != 0)
        return other.error();
    const int error = renamed(one, other, Rename::to_free);
    if (!unknown(error))
        return error;
    return renamed_over_claim(one, other);
}

int swap_names(const fs::path& one, const fs::path& other) {
    const Way first(one), second(other);
    const int error = refused(first, second);
    return error != 0 ? error : renamed(first, second, Rename::swap);
}

int remove_name(const fs::path& file) noexcept try {
    const Way way(file);
    if (const int error = way.refused(); error != 0)
        return error;
    return ::unlinkat(way.folder(), way.name(), 0) == 0 ? 0 : errno;
} catch (...) { // no memory for its name
    return ENOMEM;
}

int remove_directory(const fs::path& folder) {
    const Way way(folder);
    if (const int error = way.refused(); error != 0)
        return error;
    return ::unlinkat(way.folder(), way.name(), AT_REMOVEDIR) == 0 ? 0 : errno;
}

int only_for_owner(const fs::path& file) {
    const Way way(file);
    const int error = way.refused();
    const OpenFile opened(error != 0 ? -1
                                     : ::openat(way.folder(), way.name(),
                                                O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC | O_NOFOLLOW));
    struct stat about {};
    if (error != 0 || !opened.ok() || ::fstat(opened.number(), &about) != 0)
        return error != 0 ? error : errno;
    if (S_ISDIR(about.st_mode))
        return ::fchmod(opened.number(), 0700) == 0 ? 0 : errno;
    if (!S_ISREG(about.st_mode))
        return ENXIO;
    if (about.st_nlink > 1)
        return EMLINK;
    return ::fchmod(opened.number(), 0600) == 0 ? 0 : errno;
}

bool open_to_others(const fs::path& file) {
    const auto about = Way(file).stat_of_name();
    return about && !S_ISLNK(about->st_mode) && (about->st_mode & 077U) != 0;
}

bool names_its_readers([[maybe_unused]] const fs::path& folder) {
#if defined(__linux__)
    const Way way(folder.empty() ? fs::path(".") : folder);
    const OpenFile opened(
        way.error() != 0 ? -1
                         : ::openat(way.folder(), way.name(),
                                    O_RDONLY | O_DIRECTORY | O_CLOEXEC | (way.foreign() ? O_NOFOLLOW : 0)));
    return opened.ok() && (::fgetxattr(opened.number(), "system.posix_acl_default", nullptr, 0) > 0 ||
                           has_no_rights(opened.number()));
#else
    return false;
#endif
}

bool more_open_than(const fs::path& file, const fs::path& other) {
    const auto own = Way(file).stat_of_name();
    const auto its = Way(other).stat_of_name();
    return own && its && !S_ISLNK(own->st_mode) && !S_ISLNK(its->st_mode) &&
           (own->st_mode & 077u & ~its->st_mode) != 0;
}

int no_more_open_than(const fs::path& file, const fs::path& other) {
    const OpenFile opened(file, {.follow_link = false});
    if (!opened.ok())
        return errno;
    opened.no_more_open_than(other);
    return more_open_than(file, other) ? EPERM : 0;
}

HeldElsewhere::HeldElsewhere(const std::vector<fs::path>& files) {
#if defined(TP_CAN_LEAVE_PROCESS)
    const std::vector<OpenFile> large = large_ones(files);
    std::array<int, 2> alive{};
    if (large.empty() || ::pipe2(alive.data(), O_CLOEXEC) != 0)
        return;
    const OpenFile other_end(alive[0]);
    alive_ = alive[1];
    std::vector<int> held{alive[0]};
    for (const OpenFile& file : large)
        held.push_back(file.number());
    std::ranges::sort(held);
    const pid_t child = ::_Fork();
    if (child == 0 && ::_Fork() != 0) // a grandchild, so that nobody has to wait for its end
        ::_exit(0);
    if (child == 0)
        hold(held, alive[0]);
    while (child > 0 && ::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
    }
#else
    static_cast<void>(files);
#endif
}

HeldElsewhere::~HeldElsewhere() {
    if (alive_ >= 0)
        ::close(alive_);
}

int make_directory(const fs::path& folder, Readers readers) {
    const Way way(folder);
    if (way.error() != 0)
        return way.error();
    const bool is_private = readers == Readers::owner_only && !names_its_readers(folder.parent_path());
    return ::mkdirat(way.folder(), way.name(), is_private ? 0700 : 0777) == 0 ? 0 : errno;
}

int names_to_disk(const fs::path& folder) {
    const Way way(folder.empty() ? fs::path(".") : folder);
    if (way.error() != 0)
        return way.error();
    const OpenFile directory(::openat(way.folder(), way.name(),
                                      O_RDONLY | O_DIRECTORY | O_CLOEXEC | (way.foreign() ? O_NOFOLLOW : 0)));
    if (!directory.ok()) // one that may be written to and not read
        return errno == EACCES ? 0 : errno;
    const int error = directory.to_disk();
    return error == EINVAL || error == EROFS ? 0 : error;
}

int copy_times(const OpenFile& from, const fs::path& to) {
    struct stat about {};
    if (::fstat(from.number(), &about) != 0)
        return errno;
#if defined(__APPLE__)
    const std::array<timespec, 2> times{about.st_atimespec, about.st_mtimespec};
#else
    const std::array<timespec, 2> times{about.st_atim, about.st_mtim};
#endif
    const Way way(to);
    if (way.error() != 0)
        return way.error();
    return ::utimensat(way.folder(), way.name(), times.data(), way.no_links()) == 0 ? 0 : errno;
}

long this_process() { return ::getpid(); }

bool process_lives(long number) { return ::kill(static_cast<pid_t>(number), 0) == 0 || errno == EPERM; }

} // namespace tp
