// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/contour.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace tp::svg {

/// What one stroke of a pen draws, in the units of the element that draws it. A closed one may leave its last
/// straight piece unsaid; without any piece it is a dot at `start`.
struct Subpath {
    Vec2 start{0.0};
    std::vector<Piece> pieces;
    bool closed = false;
};

/// What path data (the `d` attribute) draws; every command of the grammar, arcs as cubics within `tolerance`.
/// Every number finite. A moveto that draws nothing makes no subpath. The error names neither element nor
/// file: "is broken …". At most `piece_limit` pieces.
Result<std::vector<Subpath>> subpaths_from(std::string_view path_data, double tolerance,
                                           std::size_t piece_limit);

} // namespace tp::svg
