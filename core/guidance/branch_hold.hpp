// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/exact_law.hpp"

namespace tp {

/// Hysteresis at switches: the finger stays with the stretch of contour that pulls it, a branch, until
/// another one is nearer by `margin`. Two lids of one eye are two branches, as two contours are.
///
/// The branch is followed by going downhill on the distance along its contour from where it was met last. A
/// switch leads to a smaller distance and so to a smaller or equal energy: it can take energy from the hand,
/// never give it any. One finger has one of these; it allocates nothing.
class BranchHold {
public:
    /// `scene` must outlive it. `margin_mm` ≥ 0.
    BranchHold(const FlatScene& scene, TentProfile profile, double margin_mm)
        : scene_(&scene), profile_(profile), margin_(margin_mm) {}

    /// The guidance towards the branch held, where `exact` is the one towards the nearest of all. What a law
    /// adds to the tent (CornerCueLaw) is kept.
    Guidance hold(Vec2 finger, const Guidance& exact) noexcept;
    /// How often another branch took over while the finger was pulled.
    std::uint64_t switches() const { return switches_; }

private:
    /// Facets of an arc are seen past, so that the finger's own branch is not mistaken for another.
    static constexpr double look_ahead_mm = 2.0;
    static constexpr int most_segments = 512; ///< looked at in one step, so that the time is bounded

    Nearest nearest_of_segment(Vec2 finger, std::uint32_t segment) const noexcept;
    Nearest downhill(Vec2 finger) const noexcept;
    Guidance moved_over(const Guidance& exact, const Nearest& held) const noexcept;

    const FlatScene* scene_;
    TentProfile profile_;
    double margin_;
    int contour_ = -1; ///< held; -1: none
    std::uint32_t segment_ = 0;
    std::uint64_t switches_ = 0;
};

} // namespace tp
