// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/blended_law.hpp"

#include <numbers>

namespace tp {

BlendedLaw::BlendedLaw(const FlatScene& scene, TentProfile profile, double radius_mm)
    : index_(scene, profile.band() + radius_mm), profile_(profile), radius_(radius_mm) {
    // A sunflower: equal areas, and no two places on a line with the middle, so that no straight boundary
    // between contours passes many at once (Vogel 1979).
    constexpr double golden_angle = std::numbers::pi * (3.0 - 2.23606797749978969641);
    for (std::size_t k = 0; k < pairs; ++k) {
        const double r = radius_mm * std::sqrt((static_cast<double>(k) + 0.5) / static_cast<double>(pairs));
        const double angle = golden_angle * static_cast<double>(k);
        places_[2 * k] = r * Vec2(std::cos(angle), std::sin(angle));
        places_[2 * k + 1] = -places_[2 * k];
    }
}

Guidance BlendedLaw::at(Vec2 finger) const noexcept {
    const Nearest nearest = index_.nearest_within(finger, profile_.band() + radius_);
    if (!nearest.found()) // no force here; only the distance is wanted
        return pull_towards(index_.nearest(finger), profile_);
    return around(finger, nearest);
}

Guidance BlendedLaw::felt_at(Vec2 finger) const noexcept {
    const Nearest nearest = index_.nearest_within(finger, profile_.band() + radius_);
    return nearest.found() ? around(finger, nearest) : pull_towards(nearest, profile_);
}

Vec2 BlendedLaw::force_at(Vec2 finger) const noexcept { return felt_at(finger).force; }

Guidance BlendedLaw::around(Vec2 finger, const Nearest& nearest) const noexcept {
    Guidance guidance = pull_towards(nearest, profile_);
    Vec2 force(0.0);
    double energy = 0.0;
    for (const Vec2 away : places_) {
        const Vec2 place = finger + away;
        const Nearest there = index_.nearest_within(place, profile_.band());
        force += pull_towards(there, profile_).force;
        energy += profile_.energy(there.distance);
    }
    guidance.force = force / static_cast<double>(places_.size());
    guidance.energy = energy / static_cast<double>(places_.size());
    return guidance;
}

} // namespace tp
