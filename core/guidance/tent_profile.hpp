// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Attraction towards a contour as a function of distance: zero on the line, strongest at `range`,
/// gone at twice the range (Lim, Yoo, Choi 2019, Eq. 1 as its text describes it).
struct TentProfile {
    double stiffness = 0.2; ///< K, N/mm; > 0
    double range = 4.0;     ///< d, mm; > 0

    /// Magnitude of the force at distance `r` ≥ 0 mm, in N. Continuous; NaN in, 0 out.
    double force(double r) const;
    /// Energy stored at distance `r`, in mJ; its derivative is `force`. At most stiffness · range².
    double energy(double r) const;
    /// Distance from which on there is no force, mm.
    double band() const { return 2.0 * range; }
    /// The largest force of the profile, N.
    double peak() const { return stiffness * range; }
    /// Both parameters finite and positive.
    bool valid() const;
};

} // namespace tp
