// SPDX-License-Identifier: Apache-2.0
// A system that refuses what it is told to, in the place of the C library's own functions: for one source of a test's program.
#pragma once

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <vector>

namespace tp::testing {

/// What was asked of the system, in order: "file", "folder" (brought to the disk), "name" (given).
inline std::vector<std::string> asked;
inline int file_sync_error = 0;             ///< errno of every fsync of a file; 0: none
inline int folder_sync_error = 0;           ///< of a folder
inline int flag_error = 0;                  ///< of renameat2
inline int rename_error = 0;                ///< of renameat
inline int link_error = 0;                  ///< of every second name
inline int read_error = 0;                  ///< of every read of a file
inline int lock_error = 0;                  ///< of every lock
inline int time_error = 0;                  ///< where a file is given its time
inline int interruptions = 0;               ///< a signal comes as often before what is asked next is done
inline std::size_t most_at_once = SIZE_MAX; ///< bytes that one call writes or reads
inline bool somebody_is_sooner = false;     ///< to make a folder
inline int inherited = 0; ///< open files, of those asked about, that a program started meanwhile would have

inline bool is_folder(int descriptor) {
    struct stat about {};
    return ::fstat(descriptor, &about) == 0 && S_ISDIR(about.st_mode);
}

inline int refused(int error) {
    errno = error;
    return -1;
}

inline bool is_interrupted() { return interruptions > 0 && interruptions-- > 0; }

inline void look_whether_inherited(int descriptor) {
    inherited += (::fcntl(descriptor, F_GETFD) & FD_CLOEXEC) == 0 ? 1 : 0;
}

} // namespace tp::testing

using namespace tp::testing; // the functions below lie outside

extern "C" int fsync(int descriptor) {
    const bool folder = is_folder(descriptor);
    look_whether_inherited(descriptor);
    asked.emplace_back(folder ? "folder" : "file");
    if (const int error = folder ? folder_sync_error : file_sync_error; error != 0)
        return refused(error);
    return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

extern "C" int renameat2(int old_folder, const char* from, int new_folder, const char* to,
                         unsigned flags) noexcept {
    if (flag_error != 0)
        return refused(flag_error);
    asked.emplace_back("name");
    return static_cast<int>(::syscall(SYS_renameat2, old_folder, from, new_folder, to, flags));
}

extern "C" int renameat(int old_folder, const char* from, int new_folder, const char* to) noexcept {
    asked.emplace_back("name");
    if (rename_error != 0)
        return refused(rename_error);
    return static_cast<int>(::syscall(SYS_renameat2, old_folder, from, new_folder, to, 0));
}

extern "C" int linkat(int old_folder, const char* from, int new_folder, const char* to, int flags) noexcept {
    if (link_error != 0)
        return refused(link_error);
    return static_cast<int>(::syscall(SYS_linkat, old_folder, from, new_folder, to, flags));
}

extern "C" ssize_t read(int descriptor, void* bytes, std::size_t count) {
    look_whether_inherited(descriptor);
    if (is_interrupted())
        return refused(EINTR);
    if (read_error != 0)
        return refused(read_error);
    return ::syscall(SYS_read, descriptor, bytes, std::min(count, most_at_once));
}

extern "C" ssize_t pread64(int descriptor, void* bytes, std::size_t count, off64_t at) {
    return ::syscall(SYS_pread64, descriptor, bytes, std::min(count, most_at_once), at);
}
extern "C" ssize_t pread(int descriptor, void* bytes, std::size_t count, off_t at) {
    return pread64(descriptor, bytes, count, at);
}

extern "C" ssize_t pwrite64(int descriptor, const void* bytes, std::size_t count, off64_t at) {
    return ::syscall(SYS_pwrite64, descriptor, bytes, std::min(count, most_at_once), at);
}
extern "C" ssize_t pwrite(int descriptor, const void* bytes, std::size_t count, off_t at) {
    return pwrite64(descriptor, bytes, count, at);
}

extern "C" ssize_t write(int descriptor, const void* bytes, std::size_t count) {
    if (is_interrupted())
        return refused(EINTR);
    return ::syscall(SYS_write, descriptor, bytes, std::min(count, most_at_once));
}

extern "C" int flock(int descriptor, int operation) noexcept {
    look_whether_inherited(descriptor);
    if (is_interrupted())
        return refused(EINTR);
    if (lock_error != 0)
        return refused(lock_error);
    return static_cast<int>(::syscall(SYS_flock, descriptor, operation));
}

extern "C" int utimensat(int folder, const char* file, const timespec* times, int flags) noexcept {
    if (time_error != 0)
        return refused(time_error);
    return static_cast<int>(::syscall(SYS_utimensat, folder, file, times, flags));
}

extern "C" int mkdirat(int above, const char* folder, mode_t mode) noexcept {
    const long made = ::syscall(SYS_mkdirat, above, folder, mode);
    return made == 0 && somebody_is_sooner ? refused(EEXIST) : static_cast<int>(made);
}
