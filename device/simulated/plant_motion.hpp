// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <array>

namespace tp {

/// What moves a body in the plane; both axes alike.
struct PlantParameters {
    double mass = 0.1;      ///< kg; > 0
    double damping = 0.0;   ///< N·s/m, of device and hand together
    double coulomb = 0.0;   ///< N, dry friction
    double stiffness = 0.0; ///< N/mm, of the spring to the anchor
    double follow = 0.0;    ///< s in which the anchor follows the body; 0: it stands

    bool operator==(const PlantParameters&) const = default;
};

struct PlantState {
    Vec2 position{0.0}; ///< mm
    Vec2 velocity{0.0}; ///< mm/s
    Vec2 anchor{0.0};   ///< mm
};

/// Motion of a body under a force that is held constant (zero-order hold), by the exponential of its linear
/// system: exact for any step where dry friction is zero. An integration that is not exact damps or drives by
/// itself: semi-implicit Euler steps of 0.25 ms move the bound K (T/2 + nT) by 0.125 ms · K.
///
/// Dry friction opposes the motion, its direction held for 0.1 ms at a time; a body that comes to rest stays
/// there until more than the friction pulls. Along a line that is exact too. Allocates nothing.
class PlantMotion {
public:
    /// Moves the state on by `dt` s under `force` N.
    void advance(PlantState& state, const PlantParameters& plant, Vec2 force, double dt) noexcept;

private:
    /// What position, velocity, anchor and force before a step make of the first three after it.
    using Step = std::array<std::array<double, 4>, 4>;

    static Step step_of(const PlantParameters& plant, double dt) noexcept;
    const Step& step(const PlantParameters& plant, double dt) noexcept;
    static void apply(const Step& step, PlantState& state, Vec2 force) noexcept;
    /// The seconds of `dt` that it has gone on: fewer where the body came to rest before.
    double slide(PlantState& state, const PlantParameters& plant, Vec2 force, double dt) noexcept;

    Step last_{};
    PlantParameters last_plant_{};
    double last_dt_ = -1.0;
};

} // namespace tp
