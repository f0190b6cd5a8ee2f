// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/album_index.hpp"

#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace tp {

struct FollowedMoves {
    std::vector<Move> followed;        ///< what belonged to these is beside them again
    std::vector<std::string> problems; ///< sentences: whose recordings and words stayed where they were, and why
    bool stopped = false;              ///< the moves that are left are told again by the next scan
};

struct FollowTools {
    std::function<void(std::size_t done, std::size_t all)> progress; ///< before each move; may be empty
    std::stop_token stop;
};

/// Photographs that other programs moved or renamed keep what belongs to them: for every move that the last scan
/// recognised by content, the sidecar, contours and recordings that stayed behind go to where the photograph is now,
/// and the index forgets the move. Where a place is taken nothing goes, and the move is told again the next time. A
/// move without anything left behind is only forgotten. Scan the folders of `followed` again afterwards, so that the
/// index knows what came. An error: the database fails.
Result<FollowedMoves> follow_moves(AlbumIndex& index, const FollowTools& tools = {});

} // namespace tp
