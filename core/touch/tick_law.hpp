// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/friction/friction_finger.hpp"
#include "core/touch/tick.hpp"

namespace tp {

/// How lines are told by ticks. Chosen, not measured.
struct TickChoices {
    double strength = 0.7;  ///< amplitude of the strongest tick, 0 … 1
    double sharpness = 0.7; ///< of a crossing at a right angle, 0 … 1
};

/// The tick that tells of an event; an empty one where nothing is told. A crossing is a click, the softer the flatter its angle.
/// A line that begins to be followed is a soft tick, one that is left a sharp one, so that a finger that strays knows at once; a
/// corner is two thirds of a crossing. Of all only that share which a moving finger feels.
Tick tick_of(const LineEvent& event, const TickChoices& choices) noexcept;

/// The one tick that stands for several at once, for a finger feels no more of them: the strongest, the first of equals.
Tick tick_of(const Friction& friction, const TickChoices& choices) noexcept;

} // namespace tp
