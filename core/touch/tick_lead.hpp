// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/guided_tour.hpp"
#include "core/touch/tick_law.hpp"

namespace tp {

/// Leads a bare finger along a way. Ticks can push nobody, so they tell how near the finger is to the place that leads it: they
/// come evenly and grow toward it, and the place waits for a finger that has fallen behind. Distances and times were chosen,
/// not measured. Allocates nothing.
class TickLead {
public:
    static constexpr double every_s = 0.2;   ///< from tick to tick
    static constexpr double ahead_mm = 4.0;  ///< of a hand that follows, the place is no farther
    static constexpr double reach_mm = 12.0; ///< from here on a tick is as weak as it gets
    static constexpr double weakest = 0.1;   ///< that one, as a share of the strongest

    /// `way` in mm and with at least one point; it must outlive this.
    TickLead(const Polyline& way, Vec2 finger) : tour_(way, finger, {.max_lead = ahead_mm}) {}

    /// `dt` seconds pass with the finger there; the tick that is due now, or an empty one.
    Tick step(Vec2 finger, double dt, const TickChoices& choices) noexcept;
    /// The finger has arrived at the end; from here on there are no ticks.
    bool finished() const { return tour_.finished(); }
    double progress() const { return tour_.progress(); }
    /// The place that leads the finger, mm.
    Vec2 leader() const { return tour_.leader(); }

private:
    GuidedTour tour_;
    double since_ = every_s; ///< s, the last tick
};

} // namespace tp
