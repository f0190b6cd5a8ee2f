// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/indexed_segment.hpp"

namespace tp {

/// What keeps a finger from having to ask every segment of a node where all of them are about equally near:
/// at the centre of a circle of short chords, or where a bundle of long lines crosses. A box says nothing
/// there, since it is nearer than what it holds by more than the segments differ.
///
/// `away`: the distance to a convex set is convex, so d(p) ≥ d(q) − u·(p − q) for every place p, where q is
/// a hub, u the unit vector from q to the nearest place of the segment. `through`: the distance to a segment
/// is at least that to its line, |n·(p − q) − c|. Both hold for all segments of a node at once by the least
/// d(q), the largest |c| and the cone that holds every u or n.
struct CrowdBound {
    /// Unit vectors within an angle of at most π of a middle one.
    struct Cone {
        Vec2 middle{1.0, 0.0};
        double cosine = -1.0, sine = 0.0; ///< of the half-angle

        /// The largest product with a unit vector of the cone.
        double most(Vec2 d) const noexcept;
    };

    bool sees_away = false, sees_through = false; ///< which of the two are known
    Vec2 away_hub{0.0};
    Cone away_cone;
    double away_least = 0.0; ///< mm
    Vec2 through_hub{0.0};
    Cone through_cone;
    double through_most = 0.0; ///< mm

    /// A distance from `p`, mm, that no segment of the node is nearer than by more than rounding.
    double at_least(Vec2 p) const noexcept;
};

/// The hubs for segments `first` … `end` − 1, from some of them; what they see is still to be measured or gathered.
/// A hub of `parent`, whose segments these are among, is taken over where it serves well; null: there is none.
/// `worth_all`: one that serves badly will do.
CrowdBound with_hubs(const SegmentSet& set, std::uint32_t first, std::uint32_t end, const CrowdBound* parent,
                     bool worth_all);

/// What the hubs see of the segments.
void measure(CrowdBound& bound, const SegmentSet& set, std::uint32_t first, std::uint32_t end);

/// The same from the bounds of all parts, which may be a little worse; false where the parts have other hubs.
bool gather(CrowdBound& bound, std::span<const CrowdBound> parts);

} // namespace tp
