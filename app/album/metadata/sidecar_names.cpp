// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/sidecar_names.hpp"

#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <array>
#include <cerrno>
#include <optional>
#include <string_view>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// All spellings, likely ones first: asking for each by name is cheap however large the folder is.
constexpr std::array<std::string_view, 8> extensions = {".xmp", ".XMP", ".Xmp", ".xMp",
                                                        ".xmP", ".XMp", ".XmP", ".xMP"};

std::optional<fs::path> existing(const fs::path& stem) {
    const auto spelt = [&](std::string_view extension) {
        fs::path file = stem;
        return file += extension;
    };
    bool is_known = true;
    for (const std::string_view extension : extensions) {
        if (name_taken(spelt(extension)))
            return spelt(extension);
        is_known = is_known && !is_disks_fault(errno);
    }
    // Where the disk reports a fault there may be one; whoever reads it says so.
    return is_known ? std::nullopt : std::optional(spelt(extensions.front()));
}

} // namespace

fs::path sidecar_of(const fs::path& photo) {
    if (auto file = existing(photo))
        return *std::move(file);
    fs::path file = photo;
    file += extensions.front();
    return file;
}

std::vector<fs::path> sidecars_of(const fs::path& photo) {
    std::vector<fs::path> found;
    if (auto file = existing(photo))
        found.push_back(*std::move(file));
    if (photo.has_extension())
        if (auto file = existing(photo.parent_path() / photo.stem()))
            found.push_back(*std::move(file));
    return found;
}

} // namespace tp
