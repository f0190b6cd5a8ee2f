// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/files/open_file.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>
#include <sys/stat.h>
#if defined(__linux__)
#include <linux/magic.h>
#include <sys/vfs.h>
#endif

namespace tp {

inline std::int64_t ns_of(const timespec& time) {
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

/// What POSIX's `stat` says.
inline FileFacts facts_from(const struct stat& about) {
    FileFacts facts;
    facts.kind = S_ISREG(about.st_mode)   ? FileFacts::Kind::file
                 : S_ISDIR(about.st_mode) ? FileFacts::Kind::folder
                 : S_ISLNK(about.st_mode) ? FileFacts::Kind::link
                                          : FileFacts::Kind::other;
    facts.bytes = static_cast<std::uint64_t>(about.st_size);
#if defined(__APPLE__)
    facts.written_ns = ns_of(about.st_mtimespec);
    facts.changed_ns = ns_of(about.st_ctimespec);
#else
    facts.written_ns = ns_of(about.st_mtim);
    facts.changed_ns = ns_of(about.st_ctim);
#endif
    facts.identity = {static_cast<std::uint64_t>(about.st_dev), static_cast<std::uint64_t>(about.st_ino)};
    return facts;
}

/// Whether an open file or folder is what the kernel shows of itself, as all in /proc and /sys is: nobody's file, and reading it may
/// do something, or never end.
inline bool is_kernels(int file) {
#if defined(__linux__)
    constexpr std::array<unsigned long, 9> kernels{PROC_SUPER_MAGIC,    SYSFS_MAGIC,      DEBUGFS_MAGIC,
                                                   TRACEFS_MAGIC,       SECURITYFS_MAGIC, CGROUP_SUPER_MAGIC,
                                                   CGROUP2_SUPER_MAGIC, BPF_FS_MAGIC,     PSTOREFS_MAGIC};
    struct statfs about {};
    return ::fstatfs(file, &about) == 0 &&
           std::find(kernels.begin(), kernels.end(), static_cast<unsigned long>(about.f_type)) !=
               kernels.end();
#else
    static_cast<void>(file);
    return false;
#endif
}

} // namespace tp
