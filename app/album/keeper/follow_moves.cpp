// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/follow_moves.hpp"

#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "core/files/file_words.hpp"

namespace tp {

namespace fs = std::filesystem;

Result<FollowedMoves> follow_moves(AlbumIndex& index, const FollowTools& tools) {
    const auto moves = index.moves();
    if (!moves)
        return Error{moves.error()};
    FollowedMoves result;
    std::size_t done = 0;
    for (const Move& move : *moves) {
        if (tools.stop.stop_requested()) {
            result.stopped = true;
            break;
        }
        if (tools.progress)
            tools.progress(done++, moves->size());
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
