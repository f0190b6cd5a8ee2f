// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tp {

/// A file that may be a photograph, as its folder shows it.
struct ListedPhoto {
    std::string name;
    std::int64_t size = 0;
    std::int64_t modified_ns = 0; ///< since 1970
    std::int64_t inode = 0;
    /// Another one means that the file may have changed. Empty: it changed so lately that a further change
    /// would not be seen.
    std::string stamp;
    /// Likewise of all that lies beside it and begins with its name: sidecars, their conflict copies, mended
    /// contours, recordings.
    std::string beside;
};

struct ListedFolder {
    std::filesystem::path path; ///< absolute, without symbolic links
    std::string stamp;          ///< another one means that names in it may have changed; as of a photograph
};

struct FolderListing {
    std::string stamp;                 ///< of the folder itself
    std::vector<ListedPhoto> photos;   ///< by name
    std::vector<ListedFolder> folders; ///< by name
    std::vector<std::filesystem::path> linked; ///< links to folders, by name; nobody walks into them
    int error = 0;                     ///< why the folder cannot be read; ENOENT: it is gone
};

/// What is in a folder. Hidden files and folders are left out (`.touchphoto` is one), so are folders of
/// recordings (`IMG_1.jpg.tags`), and links to folders; a photograph may be a link itself.
FolderListing list_folder(const std::filesystem::path& folder);

/// The stamp of a folder itself, as in its listing; "gone" where there is none.
std::string folder_stamp(const std::filesystem::path& folder);

/// The recordings of a photograph: the files in `IMG_1.jpg.tags`, by name.
std::vector<std::filesystem::path> recordings_of(const std::filesystem::path& photo);

/// Where the recordings of a photograph lie.
std::filesystem::path recordings_folder(const std::filesystem::path& photo);
bool is_recordings_folder(const std::filesystem::path& folder);

} // namespace tp
