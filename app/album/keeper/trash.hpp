// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tp {

/// One deletion: what was moved away together and goes back together.
struct TrashEntry {
    std::string id;                           ///< its folder's name in the trash
    std::string what;                         ///< in a person's words, such as "IMG_1.jpg with 3 recordings"
    std::string deleted;                      ///< ISO 8601, UTC
    std::vector<std::filesystem::path> files; ///< where they were, relative to the album's folder
    std::string note; ///< what whoever deleted them needs to bring them back; the trash does not look at it
};

/// What was deleted from one folder of an album, in .touchphoto/trash inside it: moved, not copied, so that
/// deleting needs no space and cannot stop half-way in a file.
///
/// A list of what is moved is on the disk before the first file moves; a deletion or restoring that a power
/// cut stopped has each file in one of the two places, and the entry stays until all are back.
class Trash {
public:
    explicit Trash(std::filesystem::path album) : album_(std::move(album)) {}

    /// Moves files or folders (absolute, or relative to the album's folder; below it) away. The entry's id;
    /// an error says why not, and then everything is where it was.
    Result<std::string> put(const std::vector<std::filesystem::path>& files, const std::string& what,
                            const std::string& note = {});
    /// What was deleted under this id.
    Result<TrashEntry> entry(const std::string& id) const;
    /// Moves everything of an entry back to where it was, and forgets the entry. Where another file has taken
    /// a place nothing is moved and the error names it.
    /// `instead`, relative to the album's folder, is another place for an entry of one file.
    std::string restore(const std::string& id, const std::filesystem::path& instead = {});
    /// Deletes an entry for good.
    std::string erase(const std::string& id);
    std::string empty();

    /// Newest first. Entries whose list cannot be read are said in `problems`, and left alone.
    std::vector<TrashEntry> entries(std::vector<std::string>* problems = nullptr) const;
    /// Where the files of an entry lie now.
    std::vector<std::filesystem::path> files_in(const std::string& id) const;

    std::filesystem::path folder() const { return album_ / ".touchphoto" / "trash"; }

private:
    std::filesystem::path kept(const std::string& id, std::size_t number) const;
    std::string move_back(const TrashEntry& entry) const;

    std::filesystem::path album_;
};

} // namespace tp
