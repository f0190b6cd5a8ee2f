// SPDX-License-Identifier: Apache-2.0
#include "core/files/way_posix.hpp"

#include "core/files/foreign_folder.hpp"

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

#if defined(__linux__)
#include <sys/syscall.h>
#endif

namespace tp {

namespace fs = std::filesystem;

namespace {

#if defined(O_PATH)
constexpr int for_names = O_PATH | O_DIRECTORY | O_CLOEXEC;
#else
constexpr int for_names = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
#endif

#if defined(__linux__)
#if !defined(SYS_openat2)
#define SYS_openat2 437 // the same on every architecture
#endif

/// As linux/openat2.h has them, which older headers lack.
struct OpenHow {
    std::uint64_t flags, mode, resolve;
};
constexpr std::uint64_t no_magic_links = 0x02, no_symlinks = 0x04, beneath = 0x08;

/// The folder `below` `top`, in one step; −1 and `errno`: ENOSYS where the system does not know that step or does not let us.
int opened_in_one_step(int top, const fs::path& below) {
    static std::atomic<bool> unknown{false};
    if (unknown) {
        errno = ENOSYS;
        return -1;
    }
    const OpenHow how{static_cast<std::uint64_t>(for_names), 0, no_magic_links | no_symlinks | beneath};
    long opened = -1;
    do
        opened = ::syscall(SYS_openat2, top, below.c_str(), &how, sizeof how);
    while (opened < 0 && (errno == EINTR || errno == EAGAIN));
    if (opened < 0 && (errno == ENOSYS || errno == EPERM || errno == EINVAL || errno == E2BIG)) {
        unknown = true;
        errno = ENOSYS;
    }
    if (opened < 0 && errno == EXDEV) // it led out of the folder
        errno = ELOOP;
    return static_cast<int>(opened);
}
#else
int opened_in_one_step(int, const fs::path&) {
    errno = ENOSYS;
    return -1;
}
#endif

/// What "not a folder" means here: a link is none that is followed.
int folder_error(int above, const char* name) {
    const int error = errno;
    struct stat about {};
    const bool link = (error == ENOTDIR || error == ELOOP) &&
                      ::fstatat(above, name, &about, AT_SYMLINK_NOFOLLOW) == 0 && S_ISLNK(about.st_mode);
    return link ? ELOOP : error;
}

/// The same as `opened_in_one_step`, one folder after the other.
int opened_step_by_step(int top, const fs::path& below) {
    int here = top;
    for (const fs::path& name : below) {
        const int next = ::openat(here, name.c_str(), for_names | O_NOFOLLOW);
        const int error = next < 0 ? folder_error(here, name.c_str()) : 0;
        if (here != top)
            ::close(here);
        if (next < 0) {
            errno = error;
            return -1;
        }
        here = next;
    }
    return here;
}

} // namespace

Way::Way(const fs::path& file) : name_(file.native()), folder_(AT_FDCWD) {
    const auto place = foreign_place(file);
    if (!place)
        return;
    foreign_ = true;
    folder_ = -1;
    name_ = place->below.filename().native();
    const int top = ::open(place->folder.c_str(), for_names);
    if (top < 0) {
        error_ = errno;
        return;
    }
    const fs::path above = place->below.parent_path();
    if (above.empty()) {
        folder_ = top;
        return;
    }
    int opened = opened_in_one_step(top, above);
    if (opened < 0 && errno == ENOSYS)
        opened = opened_step_by_step(top, above);
    if (opened < 0)
        error_ = errno;
    else
        folder_ = opened;
    ::close(top);
}

Way::~Way() {
    if (folder_ >= 0)
        ::close(folder_);
}

int Way::no_links() const { return foreign_ ? AT_SYMLINK_NOFOLLOW : 0; }

std::optional<struct stat> Way::stat_of_name() const {
    if (error_ != 0) {
        errno = error_;
        return std::nullopt;
    }
    struct stat about {};
    if (::fstatat(folder_, name(), &about, AT_SYMLINK_NOFOLLOW) != 0)
        return std::nullopt;
    return about;
}

int Way::refused() const {
    if (error_ != 0 || !foreign_)
        return error_;
    const auto about = stat_of_name();
    return about && S_ISLNK(about->st_mode) ? ELOOP : 0;
}

} // namespace tp
