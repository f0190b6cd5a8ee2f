// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/exact_law.hpp"

namespace tp {

Guidance pull_towards(const Nearest& nearest, const TentProfile& profile) noexcept {
    Guidance guidance;
    guidance.distance = nearest.distance;
    guidance.nearest = nearest.point;
    guidance.contour = nearest.contour;
    guidance.energy = profile.energy(nearest.distance);
    guidance.segment = nearest.segment;
    guidance.towards = nearest.towards;
    const double magnitude = profile.force(nearest.distance);
    if (magnitude > 0.0)
        guidance.force = (magnitude / nearest.distance) * nearest.towards;
    return guidance;
}

Guidance ExactLaw::at(Vec2 finger) const noexcept {
    Nearest nearest = index_.nearest_within(finger, profile_.band());
    if (!nearest.found()) // no force here; only the distance is wanted
        nearest = index_.nearest(finger);
    return pull_towards(nearest, profile_);
}

Guidance ExactLaw::felt_at(Vec2 finger) const noexcept {
    return pull_towards(index_.nearest_within(finger, profile_.band()), profile_);
}

Vec2 ExactLaw::force_at(Vec2 finger) const noexcept { return felt_at(finger).force; }

} // namespace tp
