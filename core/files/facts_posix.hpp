// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/files/open_file.hpp"

#include <cstdint>
#include <ctime>
#include <sys/stat.h>

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

} // namespace tp
