// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/exact_law.hpp"

namespace tp {

Guidance ExactLaw::at(Vec2 finger) const noexcept {
    Nearest nearest = index_.nearest_within(finger, profile_.band());
    if (!nearest.found()) // no force here; only the distance is wanted
        nearest = index_.nearest(finger);
    Guidance guidance{Vec2(0.0), nearest.distance, nearest.point, nearest.contour,
                      profile_.energy(nearest.distance)};
    const double magnitude = profile_.force(nearest.distance);
    if (magnitude > 0.0)
        guidance.force = (magnitude / nearest.distance) * (nearest.point - finger);
    return guidance;
}

} // namespace tp
