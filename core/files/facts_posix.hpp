// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/files/open_file.hpp"

#include <cstdint>
#include <sys/stat.h>

namespace tp {

/// What POSIX's `stat` says.
inline FileFacts facts_from(const struct stat& about) {
    FileFacts facts;
    facts.kind = S_ISREG(about.st_mode)   ? FileFacts::Kind::file
                 : S_ISDIR(about.st_mode) ? FileFacts::Kind::folder
                 : S_ISLNK(about.st_mode) ? FileFacts::Kind::link
                                          : FileFacts::Kind::other;
    facts.bytes = static_cast<std::uint64_t>(about.st_size);
#if defined(__APPLE__)
    const timespec& written = about.st_mtimespec;
#else
    const timespec& written = about.st_mtim;
#endif
    facts.written_ns = std::int64_t{written.tv_sec} * 1'000'000'000 + written.tv_nsec;
    facts.identity = {static_cast<std::uint64_t>(about.st_dev), static_cast<std::uint64_t>(about.st_ino)};
    return facts;
}

} // namespace tp
