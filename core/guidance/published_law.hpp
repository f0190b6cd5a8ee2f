// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/guidance_law.hpp"
#include "core/guidance/scene.hpp"
#include "core/guidance/tent_profile.hpp"

#include <cstddef>
#include <vector>

namespace tp {

/// Where Algorithm 1 of Lim, Yoo, Choi 2019 pulls to, given the nearest vertex v1 and the second-nearest
/// vertex v2 (lines 4, 5 and 14 of the listing): the projection of the finger on the endless line v1v2 where
/// it lies between v1 and v2, else v1. Vertices at one place make no line, so v1 answers.
inline Vec2 published_foot(Vec2 v1, Vec2 v2, Vec2 finger) noexcept {
    const Vec2 along = v2 - v1;
    const double way = glm::dot(finger - v1, along) / glm::dot(along, along);
    return way >= 0.0 && way <= 1.0 ? v1 + way * along : v1; // v1 = v2 is 0/0, which is neither
}

/// Algorithm 1, all 25 lines of the listing: v1 and v2 over all contours, and the tent over the distance to
/// `published_foot`. Its division by that distance is kept: on the foot the result is not a number. Fewer than
/// two vertices: zero. Equally near vertices: the earlier one in `vertices`, which the listing leaves open.
Vec2 published_algorithm_1(const std::vector<Vec2>& vertices, const TentProfile& profile,
                           Vec2 finger) noexcept;

/// The published algorithm behind the interface of every law, kept for comparison. Its faults are part of it:
/// v1 and v2 may belong to different contours, v2 need not adjoin v1 where vertices are unevenly spaced, a
/// corner may choose the wrong branch, and where the foot changes from one line to the next the force has no
/// potential. Only what is not a finite number is withheld: such a force is zero.
/// No distance bounds the search for v1 and v2: a line between far vertices may pass at the finger.
/// `together` vertices in a row (> 0) are passed over at once where their bounding box is too far away for
/// any of them, which changes no answer.
class PublishedLaw final : public GuidanceLaw {
public:
    PublishedLaw(const FlatScene& scene, TentProfile profile, std::size_t together = 16);

    Guidance at(Vec2 finger) const noexcept override;

private:
    std::vector<Vec2> vertices_;
    std::vector<int> contours_; ///< of each vertex
    TentProfile profile_;
    std::size_t together_;
    std::vector<Rect> boxes_; ///< of so many vertices each
};

/// The scene's contours as points at most `spacing_mm` apart, the form in which the paper's images arrive.
FlatScene with_vertex_spacing(const FlatScene& scene, double spacing_mm);

} // namespace tp
