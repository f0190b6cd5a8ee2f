// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/force_pad/firmware/number.hpp"

namespace tp::pad {

inline constexpr int cable_count = 4;

/// A knob in the plane, pulled by four cables from fixed exits.
template <typename Real>
struct CableFrame {
    Vec<Real> exits[cable_count]; ///< mm, no three in one line
    Real least_tension = 0;       ///< N, > 0: below it a cable goes slack
    Real greatest_tension = 0;    ///< N
    Real rest_tension = 0;        ///< N, where the tensions stay near to when they may
};

template <typename Real>
struct CablePlace {
    Vec<Real> place;   ///< mm
    Real residual = 0; ///< mm, root mean square by which the four lengths contradict each other
    bool converged = false;
};

/// Where the knob is by the lengths of its cables, mm: Gauss–Newton from `start` on the sum of squares. Four
/// lengths are two more than the place needs; a cable that is slack or has slipped by s on its drum shows as
/// a residual of about s/3.
template <typename Real>
CablePlace<Real> locate(const CableFrame<Real>& frame, const Real (&lengths)[cable_count], Vec<Real> start);

template <typename Real>
struct Tensions {
    Real newtons[cable_count] = {};
    Vec<Real> force;       ///< N, what they make
    bool feasible = false; ///< it is the force that was wanted
};

/// Tensions within their bounds that make the force `wanted`, N, on the knob at `place`: of all such the
/// nearest to the tension at rest, in closed form. They form a polygon in the plane of the tensions that make
/// no force; it is clipped by the eight bounds and its nearest point taken, so that tensions change
/// continuously with place and force. Where no tensions make that force: those that make the nearest one, and
/// `feasible` is false.
template <typename Real>
Tensions<Real> distribute(const CableFrame<Real>& frame, Vec<Real> place, Vec<Real> wanted);

} // namespace tp::pad
