// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/album_index.hpp"

#include <cstddef>
#include <string>

namespace tp {

/// Photographs that came to the album since somebody was told of it last.
struct News {
    std::size_t photos = 0;
    std::size_t with_people = 0; ///< of those that were looked at
    std::size_t to_look = 0;     ///< that nobody has looked at yet

    bool operator==(const News&) const = default;
};

/// What is new in an album. Errors are sentences about the database.
class AlbumNews {
public:
    explicit AlbumNews(AlbumIndex& index) : index_(index) {}

    /// Nothing is new to whom nothing was ever told: an album that is read for the first time is as it is.
    Result<News> news();
    /// What is there now is no news any more.
    std::string told();

private:
    AlbumIndex& index_;
};

} // namespace tp
