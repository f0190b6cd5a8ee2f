// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

namespace tp {

/// A finger that is only drawn: bound to the hand by a spring, held back by dry and by viscous friction. It has no mass, so a
/// step is exact for any length: where the spring is weaker than the dry friction it sticks, else it slides toward the place
/// where both are equal.
struct BrakedFinger {
    double stiffness = 0.12;   ///< N/mm, between hand and finger: a light grip
    double hand_damping = 1.0; ///< N·s/m: without friction it follows in 8 ms
    double coulomb = 1.0;      ///< N, dry friction at level 1
    double viscous = 3.0;      ///< N·s/m, at level 1
    Vec2 place{0.0};           ///< mm

    /// `seconds` ≥ 0 pass with the hand there (mm) and friction at `level` 0 … 1.
    void step(Vec2 hand, double level, double seconds) noexcept;
    /// How far it may stay behind a resting hand, mm.
    double slack_mm(double level) const noexcept { return coulomb * level / stiffness; }
};

} // namespace tp
