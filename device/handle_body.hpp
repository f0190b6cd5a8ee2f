// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <algorithm>

namespace tp {

/// What a model's person holds, and the hand that may hold it.
struct HandlePlant {
    double mass = 0.1;           ///< kg
    double damping = 0.3;        ///< N·s/m
    double coulomb = 0.02;       ///< N, dry friction
    double hand_stiffness = 0.0; ///< N/mm between handle and hand; 0: released
    double hand_damping = 0.0;   ///< N·s/m
};

/// The body of a handle that moves in a plane, in mm.
struct HandleBody {
    Vec2 place{0.0};
    Vec2 velocity{0.0}; ///< mm/s
    Vec2 hand{0.0};

    /// There, at rest; the hand follows.
    void put(Vec2 there) {
        place = hand = there;
        velocity = Vec2(0.0);
    }

    /// A millisecond; `force_at` is what the motors pull with at a place, N. What they pulled with last.
    template <typename ForceAt>
    Vec2 step(const HandlePlant& plant, ForceAt force_at) {
        constexpr int parts = 4;
        constexpr double dt = 0.001 / parts;
        constexpr double newtons_to_mm = 1000.0; // N/kg = m/s²; the state is in mm
        Vec2 force(0.0);
        for (int i = 0; i < parts; ++i) {
            force = force_at(place);
            const Vec2 total = force + plant.hand_stiffness * (hand - place) -
                               1e-3 * (plant.damping + plant.hand_damping) * velocity;
            velocity += dt * newtons_to_mm / plant.mass * total;
            const double speed = length(velocity);
            const double loss = dt * newtons_to_mm / plant.mass * plant.coulomb;
            velocity *= speed > 0.0 ? std::max(0.0, speed - loss) / speed : 0.0;
            place += dt * velocity;
        }
        return force;
    }
};

} // namespace tp
