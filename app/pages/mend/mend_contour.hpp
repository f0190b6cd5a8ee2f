// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/contour.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// A point by which a contour is mended.
struct MendNode {
    enum class Kind {
        corner, ///< on the curve; the direction may change here. Both ends of an open contour are corners
        smooth, ///< on the curve, on the straight line between the anchors (the others) before and after it: G1
        control ///< off the curve
    };
    Vec2 at{0.0};
    Kind kind = Kind::corner;

    bool on_curve() const { return kind != Kind::control; }
    bool operator==(const MendNode&) const = default;
};

/// A contour as the points that a person takes hold of, in their order along it: those on the curve with the
/// controls of the piece (none: straight, one: quadratic, two: cubic) that leaves them behind them. The first
/// one is on the curve, of an open contour the last one too.
struct MendContour {
    std::string name;
    std::vector<MendNode> nodes;
    bool closed = false;

    bool operator==(const MendContour&) const = default;
};

/// The contour's points; nothing where it has no piece. What joins within 1° is smooth, between two straight
/// pieces only what does not turn at all.
std::optional<MendContour> mendable(const Contour& contour);
/// Back again: for a contour whose pieces join, exactly what `mendable` was given.
Contour contour_of(const MendContour& contour);

/// Moves one point. Smooth joins stay smooth: those beside it slide along, and with a smooth one that is moved
/// itself go the controls that give its direction. One between two corners becomes a corner. Not finite: no
/// change.
void move_node(MendContour& contour, std::size_t node, Vec2 to);
/// Moves the whole contour.
void move_all(MendContour& contour, Vec2 by);

/// A new point on the curve where it passes nearest to `place`; the curve stays as it is. Its index.
std::size_t add_node_near(MendContour& contour, Vec2 place);
/// The same in the middle of the piece that `node` belongs to or begins; of the last one of an open contour,
/// in the middle of the piece that ends there.
std::size_t add_node_after(MendContour& contour, std::size_t node);
/// Takes a point out; a control leaves its piece straight. False, and no change, where fewer than two points
/// on the curve (three of a closed contour without controls) would be left.
bool delete_node(MendContour& contour, std::size_t node);
/// A smooth point becomes a corner and the other way round, which lays it on the line between the anchors
/// beside it. False, and no change, for a control, an end, and a point between two corners.
bool toggle_corner(MendContour& contour, std::size_t node);

/// The rectangle round all points.
Rect bounds_of(const MendContour& contour);

} // namespace tp
