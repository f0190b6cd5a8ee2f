// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace tp {

/// A folder of which somebody else may have made what is in it: an album on a stick, out of an archive, from a cloud. While one
/// lives, whatever this room does with a name below the folder follows no link there, neither the name nor a folder on the way to
/// it: what is a link is refused with ELOOP, what is no plain file is not opened (ENXIO), and a file that has other names too is
/// replaced, never written into (EMLINK). The folder itself may be reached by links: a person named it.
///
/// What lies beside a photograph or is an album's own – `.touchphoto`, `one.jpg.tags`, `one.jpg.xmp`, `one.jpg.contours.svg` – is
/// held so everywhere, whether or not a ForeignFolder lives. Any thread.
class ForeignFolder {
public:
    explicit ForeignFolder(const std::filesystem::path& folder);
    ForeignFolder(const ForeignFolder& other);
    ForeignFolder& operator=(const ForeignFolder&) = delete;
    ~ForeignFolder();

private:
    std::filesystem::path folder_; ///< absolute, without dots
};

/// A name as it is held: from `folder`, which may be reached by links, `below` is reached without.
struct ForeignPlace {
    std::filesystem::path folder;
    std::filesystem::path below; ///< at least one name, no dots
};

/// None: the name is the person's own, and links are followed as everywhere.
std::optional<ForeignPlace> foreign_place(const std::filesystem::path& file);

/// What of this is a link, where links are not followed: the file, or the first folder on the way to it. None: nothing.
std::optional<std::filesystem::path> link_on_the_way(const std::filesystem::path& file);

/// That it is, as a sentence.
std::string left_alone(const std::filesystem::path& link);

} // namespace tp
