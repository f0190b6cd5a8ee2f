// SPDX-License-Identifier: Apache-2.0
#include "path_check.hpp"

#include "core/svg/path_pieces.hpp"

namespace tp::test {

std::string complaint_about_path(std::string_view path_data) {
    constexpr std::size_t most_pieces = 1000;
    const auto subpaths = svg::subpaths_from(path_data, 1e-3, most_pieces);
    if (!subpaths)
        return subpaths.error().size() > 10 ? "" : "refused without words";
    std::size_t pieces = 0;
    for (const svg::Subpath& subpath : *subpaths) {
        if (!is_finite(subpath.start))
            return "a start is not finite";
        if (subpath.pieces.empty() && !subpath.closed)
            return "an open stroke draws nothing";
        Vec2 at = subpath.start;
        for (const Piece& piece : subpath.pieces) {
            if (!is_finite(piece))
                return "a piece is not finite";
            if (start_of(piece) != at)
                return "a stroke is torn";
            at = end_of(piece);
        }
        pieces += subpath.pieces.size();
    }
    return pieces <= most_pieces ? "" : "more pieces than allowed";
}

} // namespace tp::test
