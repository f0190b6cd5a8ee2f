// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/check/finding.hpp"
#include "app/album/keeper/album_keeper.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tp {

/// What a check has found so far; each is mended when it is found, where it can and shall be.
class Findings {
public:
    using Mending = std::function<std::string()>; ///< why it could not be mended; empty: it is

    Findings(const std::filesystem::path& album, bool mend) : album_(album), keeper_(album), mends_(mend) {}

    /// What a person alone can decide.
    void add(Finding::Kind kind, const std::filesystem::path& file, const std::string& sentence);
    void add(Finding::Kind kind, const std::filesystem::path& file, const std::string& sentence,
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
