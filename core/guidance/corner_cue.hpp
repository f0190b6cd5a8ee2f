// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/contour_index.hpp"
#include "core/guidance/guidance_law.hpp"
#include "core/guidance/tent_profile.hpp"

#include <memory>
#include <numbers>
#include <vector>

namespace tp {

/// Where contours turn sharply, as a finger feels it: by more than `turn_degrees` between the directions
/// `window_mm` before and behind the place. Of places closer than two windows along a contour the sharpest.
/// An end of an open contour is none.
std::vector<Vec2> corners_of(const FlatScene& scene, double turn_degrees = 30.0, double window_mm = 1.0);

/// Another law with a shallow well of energy at every corner, −E·(1 − (ρ/R)²)² within R = d/2: a finger that
/// passes is drawn on and then held back for a moment, a tick of a fifth of the peak K·d. The paper found
/// corners slow to recognise for want of a cue. Being a potential the well does no net work, at any speed.
class CornerCueLaw final : public GuidanceLaw {
public:
    /// The strongest pull of a well, as a share of the profile's peak.
    static constexpr double share_of_peak = 0.2;
    /// The stiffness at the middle of a well, 4E/R², as a share of the profile's: 3√3 · share_of_peak.
    static constexpr double share_of_stiffness = 3.0 * std::numbers::sqrt3 * share_of_peak;

    CornerCueLaw(std::unique_ptr<const GuidanceLaw> law, const FlatScene& scene, TentProfile profile);

    Guidance at(Vec2 finger) const noexcept override;
    Guidance felt_at(Vec2 finger) const noexcept override;
    std::size_t corner_count() const { return corners_.segment_count(); }
    /// How far a well reaches, mm.
    double reach() const { return reach_; }

private:
    Guidance with_well(Guidance guidance, Vec2 finger) const noexcept;

    std::unique_ptr<const GuidanceLaw> law_;
    double reach_;
    double depth_; ///< E, mJ
    ContourIndex corners_;
};

} // namespace tp
