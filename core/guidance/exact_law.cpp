// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/exact_law.hpp"

namespace tp {

Guidance pull_towards(const Nearest& nearest, Vec2 finger, const TentProfile& profile) noexcept {
    Guidance guidance{
        Vec2(0.0),      nearest.distance, nearest.point, nearest.contour, profile.energy(nearest.distance),
        nearest.segment};
    const double magnitude = profile.force(nearest.distance);
    if (magnitude > 0.0)
        guidance.force = (magnitude / nearest.distance) * (nearest.point - finger);
    return guidance;
}

Guidance ExactLaw::at(Vec2 finger) const noexcept {
    Nearest nearest = index_.nearest_within(finger, profile_.band());
    if (!nearest.found()) // no force here; only the distance is wanted
        nearest = index_.nearest(finger);
    return pull_towards(nearest, finger, profile_);
}

Vec2 ExactLaw::force_at(Vec2 finger) const noexcept {
    return pull_towards(index_.nearest_within(finger, profile_.band()), finger, profile_).force;
}

} // namespace tp
