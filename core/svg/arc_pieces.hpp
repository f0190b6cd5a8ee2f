// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/contour.hpp"
#include "core/geometry/transform.hpp"

#include <vector>

namespace tp::svg {

/// How far a cubic may run from the arc it stands for, in units of the sheet.
constexpr double arc_tolerance = 5e-7;

/// Appends cubics for the arc of the ellipse that `unit_circle` makes of the unit circle, from the angle
/// `start` on through `sweep` radians, at most `tolerance` away from it (but no closer than rounding lets
/// them be). The first one starts exactly at `from`, the last one ends exactly at `to`.
void append_arc(std::vector<Piece>& pieces, const Affine& unit_circle, double start, double sweep, Vec2 from,
                Vec2 to, double tolerance);

/// The elliptical arc of the path grammar: radii `rx` and `ry` above zero, x axis turned by `rotation`
/// radians. A straight line where the arc is too flat to be told from one.
void append_path_arc(std::vector<Piece>& pieces, Vec2 from, double rx, double ry, double rotation, bool large,
                     bool clockwise, Vec2 to, double tolerance);

} // namespace tp::svg
