// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string>

namespace tp {

// Names in a bundle. libarchive, and the programs that people unpack with, compose letters (NFC), take "\" for "/" and, where the
// locale is not UTF-8, refuse what is not ASCII. What would come back as another name is percent-encoded behind "%:" (`path_text`).

std::string name_in_bundle(const std::filesystem::path& path);
/// An error where it is not one that leads to a place in the folder that the bundle is unpacked to.
Result<std::filesystem::path> path_in_bundle(const std::string& name);

/// While one lives, the system's and libarchive's functions take and give text as UTF-8 on this thread, whatever the locale of the
/// program is.
class Utf8Names {
public:
    Utf8Names();
    ~Utf8Names();
    Utf8Names(const Utf8Names&) = delete;
    Utf8Names& operator=(const Utf8Names&) = delete;

private:
    void* made_ = nullptr;   ///< a locale_t
    void* before_ = nullptr; ///< the same
};

} // namespace tp
