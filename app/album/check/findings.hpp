// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/check/finding.hpp"
#include "app/album/keeper/album_keeper.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace tp {

/// What `look` gives, with a second look where the first gives nothing: a disk's fault may have passed.
template <typename Look>
auto looked_twice(Look look) {
    auto seen = look();
    return seen ? std::move(seen) : look();
}

/// What a check has found so far; each is mended when it is found, where it can and shall be.
class Findings {
public:
    using Mending = std::function<std::string()>; ///< why it could not be mended; empty: it is

    Findings(const std::filesystem::path& album, bool mend) : album_(album), keeper_(album), mends_(mend) {}

    /// What a person alone can decide.
    void add(Finding::Kind kind, const std::filesystem::path& file, const std::string& sentence);
    void add(Finding::Kind kind, const std::filesystem::path& file, const std::string& sentence,
             const std::string& mend, const Mending& mending);
    /// Of a folder that was listed with this error, once. False where all that is in it is known: there was no error, it is not
    /// there, or it is told as a link or as no file.
    bool add_folder(const std::filesystem::path& folder, int error);
    /// Of a file that is damaged: it is mended only where all of its bytes can be read. A disk's fault is none of the file's.
    void add_damaged(Finding::Kind kind, const std::filesystem::path& file, const std::string& sentence,
                     const std::string& mend, const Mending& mending);

    const std::filesystem::path& album() const { return album_; }
    AlbumKeeper& keeper() { return keeper_; }
    bool mends() const { return mends_; }
    const std::vector<Finding>& all() const { return all_; }

private:
    std::filesystem::path album_;
    AlbumKeeper keeper_;
    bool mends_;
    std::vector<Finding> all_;
};

} // namespace tp
