// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/album_index.hpp"
#include "app/album/index/folder_listing.hpp"
#include "app/album/index/sql_connection.hpp"
#include "core/files/foreign_folder.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace tp {

/// In what an album's folders differ from the index.
struct FolderChanges {
    /// A photograph to read: a new one, or one that changed.
    struct Job {
        std::filesystem::path folder;
        ListedPhoto listed;
        std::string known_hash; ///< its content did not change
    };

    std::vector<Job> jobs;
    std::vector<std::pair<std::filesystem::path, std::string>>
        folders;                                                 ///< that could be read, with their stamps
    std::vector<std::pair<PhotoId, std::filesystem::path>> gone; ///< photographs that are not where they were
    std::vector<std::int64_t> lost_folders; ///< ids of folders that are not there any more
    std::size_t found = 0;                  ///< photographs and what may be one
    std::vector<std::string> problems;      ///< sentences
};

/// Walks folders of an album and compares what they show with the index, of which it only reads.
class FolderWalk {
public:
    FolderWalk(SqlConnection& connection, std::stop_token stop);

    /// Takes a folder and all below it.
    void walk(const std::filesystem::path& top);
    /// Takes one folder, and of those in it the ones that are new, gone, or look otherwise than they did.
    void look_into(const std::filesystem::path& top);
    /// Loses all folders of the index that were not walked. Of folders that cannot be read nobody knows what
    /// is in them: they stay as they were.
    void miss_unseen_folders();

    FolderChanges& changes() { return changes_; }
    bool was_walked(const std::filesystem::path& folder) const { return seen_.contains(folder.native()); }

private:
    struct StoredPhoto {
        PhotoId id = 0;
        std::string stamp, beside, hash;
        bool missing = false;
    };

    void compare(const std::filesystem::path& folder, FolderListing& listing);
    void tell_links(const FolderListing& listing);
    void cannot_read(const std::filesystem::path& folder, int error);
    void lose_folder(std::int64_t id, const std::filesystem::path& folder);
    void lose_folders(const std::filesystem::path& top);
    std::map<std::string, StoredPhoto> stored_in(const std::filesystem::path& folder);
    std::vector<std::pair<std::int64_t, std::filesystem::path>> present_folders(const std::string& from,
                                                                                const std::string& to);
    std::optional<std::string> stamp_of(const std::filesystem::path& folder);

    SqlConnection& connection_;
    std::stop_token stop_;
    FolderChanges changes_;
    std::set<std::string> seen_; ///< folders that were walked
    std::vector<std::filesystem::path> unreadable_;
    std::vector<ForeignFolder> held_; ///< folders that were walked
};

} // namespace tp
