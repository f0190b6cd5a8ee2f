// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

namespace tp {

/// On which side of the line from `a` through `b` the point `p` lies: 1 left, -1 right, 0 exactly on it. Exact, however
/// close: what double cannot decide is computed as a sum without rounding (Shewchuk, "Adaptive precision floating-point
/// arithmetic and fast robust geometric predicates", Discrete & Computational Geometry 18, 1997).
///
/// Holds for finite coordinates whose differences are zero or between 1e-140 and 1e140 mm; beyond, and for what is not
/// finite, it is one of the three.
int orientation(Vec2 a, Vec2 b, Vec2 p) noexcept;

} // namespace tp
