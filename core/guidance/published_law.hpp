// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/guidance_law.hpp"
#include "core/guidance/scene.hpp"
#include "core/guidance/tent_profile.hpp"

#include <cstddef>
#include <vector>

namespace tp {

/// Algorithm 1 of Lim, Yoo, Choi 2019, step by step as published: the nearest vertex v1 and the
/// second-nearest vertex v2 over all contours, the finger projected on the endless line v1v2, the tent over
/// that distance. Its division by the distance is kept: on the line the result is not a number. Fewer than
/// two vertices: zero. Equally near vertices: the earlier one in `vertices`.
Vec2 published_algorithm_1(const std::vector<Vec2>& vertices, const TentProfile& profile,
                           Vec2 finger) noexcept;

/// The published algorithm behind the interface of every law, kept for comparison. Its faults are part of it:
/// v1 and v2 may belong to different contours, v2 need not adjoin v1 where vertices are unevenly spaced, and
/// a corner may choose the wrong branch. Only what is not a finite number is withheld: such a force is zero.
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
