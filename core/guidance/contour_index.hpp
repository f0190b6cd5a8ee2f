// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/scene.hpp"

#include <limits>
#include <vector>

namespace tp {

/// The place on a scene's contours that is nearest to a point.
struct Nearest {
    double distance = std::numeric_limits<double>::infinity(); ///< mm
    Vec2 point{0.0};                                           ///< mm; meaningless where contour < 0
    int contour = -1;                                          ///< index into FlatScene, -1 for none

    bool found() const { return contour >= 0; }
};

/// Nearest point over the segments of a flattened scene, exact in double precision.
///
/// Ties are broken by the smaller x, then the smaller y of the nearest point, then by the contour's name, so
/// the answer does not depend on the order of contours or segments nor on the direction they were drawn in.
/// Segments with a coordinate that is not finite are left out. A query allocates nothing and throws nothing.
class ContourIndex {
public:
    explicit ContourIndex(const FlatScene& scene);

    /// Nothing is found for a point that is not finite, or in an empty scene.
    Nearest nearest(Vec2 p) const noexcept;
    std::size_t segment_count() const { return segments_.size(); }

private:
    struct Segment {
        Vec2 a, b;
        int contour;
        int name_rank;
    };
    template <typename Measure>
    Nearest scan(Vec2 p, Measure measure) const noexcept;

    std::vector<Segment> segments_;
};

} // namespace tp
