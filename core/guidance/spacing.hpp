// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/scene.hpp"
#include "core/guidance/tent_profile.hpp"

#include <optional>
#include <vector>

namespace tp {

/// Two lines nearer than this cannot be told apart by force, mm (DESIGN.md §4).
inline constexpr double tellable_gap_mm = 1.0;

/// Two contours that come closer to each other than the reach of both their pulls.
struct Closeness {
    int first = 0;        ///< index into the FlatScene
    int second = 0;       ///< index; larger than `first`
    double gap = 0.0;     ///< mm, smallest distance between them
    Vec2 where{0.0};      ///< mm, on the first contour, at the smallest gap
    double peak = 0.0;    ///< N, the strongest pull that is left between them: K·gap/2, at most K·d
    bool tellable = true; ///< gap of at least tellable_gap_mm; crossing and touching contours are not
};

/// Every pair of contours closer than 2d, the narrowest gap first. Exact over the segments.
std::vector<Closeness> closeness(const FlatScene& scene, const TentProfile& profile);

/// A profile for contours that come as close as `pairs` (from `closeness` with `profile`): a range of a
/// quarter of the narrowest tellable gap, so that the pulls of two neighbours end before they meet and
/// nothing jumps between them, and the stiffness that keeps the peak. Range and stiffness stay within what
/// Lim, Yoo, Choi 2019 tried: at least 2 mm, at most 0.5 N/mm. Nothing where `profile` is as good.
std::optional<TentProfile> proposed_profile(const std::vector<Closeness>& pairs, const TentProfile& profile);

/// A closed contour so narrow that its two sides cannot be told apart (a shut eye, shut lips) as the one line
/// between them, from its one end to the other; nothing where it is open, or its sides are at least `gap` mm
/// apart somewhere. The name is kept.
std::optional<Contour> thinned(const Contour& contour, double gap = tellable_gap_mm);

} // namespace tp
