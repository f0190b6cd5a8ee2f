// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tp {

/// What softens or marks the places where the direction of the exact force jumps: the lines between contours,
/// where the nearest one changes. At a distance r and with an angle α between the two pulls the jump is
/// 2K·min(r, 2d−r)·sin(α/2), at most 2K·d. All of it off is the exact law. What each costs in accuracy stands
/// in app/figures/report/FIGURES.md.
struct Continuity {
    /// mm; the finger stays with the stretch of contour that pulls it until another is nearer by this much
    /// (BranchHold); 0: off. 0.3–0.5 keeps a trembling finger from clicking to and fro.
    double hold_mm = 0.0;
    /// mm; the force is the mean of the exact one over a disc of this radius (BlendedLaw); 0: off. 0.3–0.5
    /// turns the click into a slope.
    double blend_mm = 0.0;
    /// A shallow well of energy at every corner, felt as a short tick in passing (CornerCueLaw).
    bool corner_cue = false;

    bool off() const { return hold_mm == 0.0 && blend_mm == 0.0 && !corner_cue; }
    /// A sentence where a width is not from 0 to 5 mm or both are above zero; else empty.
    std::string problem() const;
};

} // namespace tp
