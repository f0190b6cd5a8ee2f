// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace tp {

/// The folder of a photograph's recordings: IMG_1.jpg.tags beside IMG_1.jpg.
std::filesystem::path tags_folder(const std::filesystem::path& photo);
/// The contours that a person mended: IMG_1.jpg.contours.svg.
std::filesystem::path contours_file(const std::filesystem::path& photo);

/// The folder that an album keeps its own things in, trash and all: .touchphoto.
bool is_own_folder(const std::filesystem::path& folder);
/// The album that a photograph's own things are kept in where nobody named one: the nearest folder above it
/// that has a .touchphoto, else its own folder. Where the way to the photograph leads by a link that lies in an album, it is that
/// album, in which nothing behind the link is reached.
std::filesystem::path album_around(const std::filesystem::path& photo);

/// A file or folder that belongs to a photograph and goes where it goes.
struct Companion {
    std::filesystem::path file;
    std::string suffix;   ///< what its name has behind the photograph's, ".xmp", or behind its stem
    bool by_stem = false; ///< IMG_1.xmp: named by the stem, as Lightroom does
};

/// What lies beside a photograph and is its own: both spellings of a sidecar, its conflict copies, contours,
/// recordings. A sidecar named by the stem belongs to it only where no other photograph in the folder has
/// that stem.
/// What has such a name and is a link, or neither file nor folder, is none; `left` takes it.
std::vector<Companion> companions_of(const std::filesystem::path& photo,
                                     std::vector<std::filesystem::path>* left = nullptr);

/// The same for many photographs, by folder: a folder is read once, when the first of its photographs is
/// asked for, so that ten thousand photographs in one take no hundred million looks.
class FolderCompanions {
public:
    std::vector<Companion> of(const std::filesystem::path& photo,
                              std::vector<std::filesystem::path>* left = nullptr);
    /// Why the folder of the last photograph could not be listed, errno; 0: it could.
    int fault() const { return fault_; }

private:
    void read(const std::filesystem::path& folder);

    std::optional<std::filesystem::path> folder_; ///< the one that was read last
    std::vector<std::string> names_;              ///< of what is in it, in order
    std::set<std::string> left_;                  ///< of links, and of what is neither file nor folder
    int fault_ = 0;
};

/// "IMG_1 (2).jpg" for the second photograph of that name.
std::filesystem::path numbered(const std::filesystem::path& place, int number);

/// The name that a companion has beside a photograph of another name or folder.
std::filesystem::path beside(const std::filesystem::path& photo, const Companion& companion);

/// How long a file is, bytes; 0 where that cannot be known.
std::uintmax_t size_or_zero(const std::filesystem::path& file);

/// SHA-256 of a file's bytes, hexadecimal; a sentence where it cannot be read.
Result<std::string> content_hash(const std::filesystem::path& file);

} // namespace tp
