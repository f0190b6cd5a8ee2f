// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/contour_index.hpp"
#include "core/guidance/guidance_law.hpp"
#include "core/guidance/tent_profile.hpp"

namespace tp {

/// The tent towards `nearest`, seen from the finger that it was asked for; nothing at distance zero.
Guidance pull_towards(const Nearest& nearest, const TentProfile& profile) noexcept;

/// Exact guidance, the default: the tent over the true distance to the nearest point of all contours.
/// The force is minus the gradient of a continuous potential, so a closed path does no net work.
/// On a contour the force is zero without a division.
class ExactLaw final : public GuidanceLaw {
public:
    ExactLaw(const FlatScene& scene, TentProfile profile)
        : index_(scene, profile.band()), profile_(profile) {}

    Guidance at(Vec2 finger) const noexcept override;
    Guidance felt_at(Vec2 finger) const noexcept override;
    Vec2 force_at(Vec2 finger) const noexcept override;
    /// The potential at `finger`, mJ; outside the band the constant stiffness · range².
    double energy(Vec2 finger) const noexcept { return profile_.energy(index_.nearest(finger).distance); }

private:
    ContourIndex index_;
    TentProfile profile_;
};

} // namespace tp
