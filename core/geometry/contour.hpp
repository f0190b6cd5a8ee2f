// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <string>
#include <variant>
#include <vector>

namespace tp {

/// Straight piece from `a` to `b`.
struct Line {
    Vec2 a{0.0}, b{0.0};
};
/// Quadratic Bézier piece.
struct Quadratic {
    Vec2 a{0.0}, control{0.0}, b{0.0};
};
/// Cubic Bézier piece.
struct Cubic {
    Vec2 a{0.0}, control_a{0.0}, control_b{0.0}, b{0.0};
};
using Piece = std::variant<Line, Quadratic, Cubic>;

Vec2 start_of(const Piece& piece);
Vec2 end_of(const Piece& piece);
/// The point at parameter `t` in [0, 1].
Vec2 point_at(const Piece& piece, double t);
/// Every defining point finite.
bool is_finite(const Piece& piece);

/// A named line that a finger can follow: pieces that join end to start. A closed contour's last piece ends
/// where its first one starts.
struct Contour {
    std::string name;
    std::vector<Piece> pieces;
    bool closed = false;
};

/// Straight pieces through `points`; with `closed`, a last piece leads back to the first point (which must
/// not be repeated at the end of `points`). A single point becomes one piece of length zero.
Contour contour_through(std::string name, const std::vector<Vec2>& points, bool closed);

/// The same curve with every defining point mapped by `map`, which must be affine for Béziers to stay exact.
template <typename Map>
Contour mapped(const Contour& contour, const Map& map) {
    struct Mapper {
        const Map& map;
        Piece operator()(const Line& p) const { return Line{map(p.a), map(p.b)}; }
        Piece operator()(const Quadratic& p) const { return Quadratic{map(p.a), map(p.control), map(p.b)}; }
        Piece operator()(const Cubic& p) const {
            return Cubic{map(p.a), map(p.control_a), map(p.control_b), map(p.b)};
        }
    };
    Contour result{contour.name, {}, contour.closed};
    result.pieces.reserve(contour.pieces.size());
    for (const Piece& piece : contour.pieces)
        result.pieces.push_back(std::visit(Mapper{map}, piece));
    return result;
}

} // namespace tp
