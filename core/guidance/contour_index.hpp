// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/cell_grid.hpp"
#include "core/guidance/scene.hpp"

namespace tp {

/// The place on a scene's contours that is nearest to a point.
struct Nearest {
    double distance = std::numeric_limits<double>::infinity(); ///< mm
    Vec2 point{0.0};                                           ///< mm; meaningless where contour < 0
    int contour = -1;                                          ///< index into FlatScene, -1 for none
    std::uint32_t segment =
        0; ///< of the contour's line, one that passes there; meaningless where contour < 0

    Vec2 towards{
        0.0}; ///< mm, from the place asked for to the nearest one, true where the coordinates of both
              ///< are so large that their difference is not; zero where contour < 0

    bool found() const { return contour >= 0; }
};

/// Nearest point over the segments of a flattened scene, exact in double precision.
///
/// Ties are broken by the smaller x, then the smaller y of the nearest point, then by the contour's name (of
/// contours with one name the first), so the answer does not depend on the order of contours or segments nor
/// on the direction they were drawn in. Segments with a coordinate that is not finite are left out.
///
/// Two structures answer. A grid of cells, fine within the band, where forces are, and coarse around it,
/// keeps for each cell the few segments that can be nearest in it; a packed R-tree answers the rest: farther
/// away, where too many segments meet in one cell, and wherever cells would not fit. Ties are those of the
/// distances as computed. Where the tree has asked more than SegmentTree::crowd segments without an end,
/// those nearer than another by less than SegmentTree::indistinct_mm may be passed over: at the centre of
/// a circle of 100 000 segments any of them may be the answer, the same one each time. Up to 1e6 mm of size
/// the distance is true to 1e-9 mm. Queries allocate nothing, lock nothing, throw nothing and change nothing,
/// so any number of threads may ask.
class ContourIndex {
public:
    /// The band of the default profile, mm.
    static constexpr double usual_band_mm = 8.0;

    /// `band_mm` > 0: how far from a contour queries are to be fast. The answers do not depend on it.
    explicit ContourIndex(const FlatScene& scene, double band_mm = usual_band_mm);

    /// Nothing is found for a point that is not finite, or in an empty scene.
    Nearest nearest(Vec2 p) const noexcept;
    /// The same where the distance is at most `reach` mm; beyond, nothing is found. Costs next to nothing for
    /// a point beyond the band where `reach` is at most the band.
    Nearest nearest_within(Vec2 p, double reach) const noexcept;

    /// Segments of the scene, those that repeat another one not counted.
    std::size_t segment_count() const { return set_.size(); }
    double band_mm() const { return band_; }
    /// Memory held, bytes.
    std::size_t bytes() const;

private:
    template <typename Real>
    Nearest answer(const Closest<Real>& closest, Vec2 p) const noexcept;
    [[gnu::noinline]] Nearest answer_on_long(std::uint32_t segment, Vec2 p) const noexcept;
    [[gnu::noinline]] Nearest careful(Vec2 p, double reach) const noexcept;
    [[gnu::noinline]] Nearest from_tree(Vec2 p, double reach) const noexcept;

    SegmentSet set_;
    SegmentTree tree_;
    CellGrid grid_;
    std::vector<int> contours_; ///< index into FlatScene for each owner
    double band_;
    bool wide_ = false; ///< segments so long that double loses more than 1e-10 mm
};

} // namespace tp
