// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string_view>
#include <vector>

namespace tp {

/// Everything in the album, sorted by what it is; so that what is found does not depend on the order of
/// names.
struct Inventory {
    std::vector<std::filesystem::path> photos;
    std::vector<std::filesystem::path> temporaries;
    std::vector<std::filesystem::path> tags;     ///< folders of recordings
    std::vector<std::filesystem::path> others;   ///< sidecars and mended contours
    std::vector<std::filesystem::path> links;    ///< to whatever; of photographs too
    std::vector<std::filesystem::path> no_files; ///< pipes, devices and such
    std::map<std::filesystem::path, int>
        unread; ///< folders that could not be listed whole, and the system's number
};

Inventory inventory_of(const std::filesystem::path& album);

constexpr std::string_view tags_end = ".tags", contours_end = ".contours.svg", xmp_end = ".xmp";

} // namespace tp
