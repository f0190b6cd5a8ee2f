// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/album_queries.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tp {

/// Photographs that a person goes through one by one: a list of the index, or what a search found, the best
/// first. Knows where one is; the index may change meanwhile. Errors are sentences about the database, and
/// nothing has moved then.
class PhotoTrail {
public:
    using Found = std::vector<PhotoEntry>;
    PhotoTrail(AlbumIndex& index, PhotoList list) : index_(&index), way_(std::move(list)) {}
    PhotoTrail(AlbumIndex& index, Found found) : index_(&index), way_(std::move(found)) {}

    /// Where one is; none before the first step.
    const std::optional<PhotoEntry>& here() const { return here_; }
    std::size_t count() const { return count_; }
    std::size_t position() const { return position_; } ///< from 1; 0: nowhere

    /// Each returns whether it moved.
    Result<bool> to_first() { return to_end(Direction::forward); }
    Result<bool> to_last() { return to_end(Direction::backward); }
    Result<bool> next() { return step(Direction::forward); }
    Result<bool> previous() { return step(Direction::backward); }
    /// To this very photograph; it stays where it is if the trail does not have it.
    Result<bool> to(const PhotoEntry& photo);
    /// Counts anew after the index changed. Where the photograph is gone it goes to where its bytes are now,
    /// else to the next one, else to the one before; whether one is still at the same photograph.
    Result<bool> look_again(const std::string& sha256);

    /// Those that may be wanted after this one, the likeliest first.
    std::vector<std::filesystem::path> ahead(bool backwards) const;

private:
    Result<bool> to_end(Direction direction);
    Result<bool> step(Direction direction);
    Result<std::optional<PhotoEntry>> beside(const PhotoEntry& photo, Direction direction) const;
    Result<std::optional<PhotoEntry>> find_again(const PhotoEntry& photo, const std::string& sha256) const;
    bool is_in(const PhotoList& list, const PhotoEntry& photo) const;
    std::string recount();
    std::optional<std::size_t> found_at(const Found& found, const PhotoEntry& photo) const;

    AlbumIndex* index_;
    std::variant<PhotoList, Found> way_;
    std::optional<PhotoEntry> here_;
    std::size_t count_ = 0, position_ = 0;
};

} // namespace tp
