// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <climits>
#include <cstdio>
#include <string>
#include <unistd.h>

namespace tp::test {

/// The whole path of what one of the system's calls is told as a name in an open folder, for who stands in for that call.
inline std::string named_place(int folder, const char* name) {
    if (folder < 0 || name[0] == '/') // AT_FDCWD
        return name;
    char link[64], path[PATH_MAX];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", folder);
    const ssize_t length = ::readlink(link, path, sizeof path);
    return length <= 0 ? std::string(name) : std::string(path, static_cast<std::size_t>(length)) + "/" + name;
}

} // namespace tp::test
