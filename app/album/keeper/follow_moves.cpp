// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/follow_moves.hpp"

#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "core/files/file_words.hpp"

namespace tp {

namespace fs = std::filesystem;

Result<FollowedMoves> follow_moves(AlbumIndex& index) {
    const auto moves = index.moves();
    if (!moves)
        return Error{moves.error()};
    FollowedMoves result;
    for (const Move& move : *moves) {
        if (!companions_of(move.from).empty()) {
            if (const std::string problem = AlbumKeeper(album_around(move.to)).move_companions(move.from, move.to);
                !problem.empty()) {
                result.problems.push_back("The photograph " + quoted(move.from) + " is now " + quoted(move.to) +
                                          ", but what belongs to it stayed behind: " + problem);
                continue;
            }
            result.followed.push_back(move);
        }
        if (std::string problem = index.forget(move.from); !problem.empty())
            return Error{std::move(problem)};
    }
    return result;
}

} // namespace tp
