// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/figures/simulated/touch_worth.hpp"
#include "core/friction/friction_finger.hpp"
#include "core/guidance/exact_law.hpp"
#include "core/participant/person.hpp"
#include "core/participant/touch_hand.hpp"

#include <deque>

namespace tp {

/// A finger on a surface that resists or ticks at one line, and what of that is felt after the latency. The arm draws it with its
/// spring, a while behind the hand; friction is a dry brake between the two, which takes as much of the spring as it holds. Being
/// the law's, it lets go where the finger all but stops.
class BareFinger {
public:
    static constexpr double tick_s = 0.001; ///< between samples of the surface
    static constexpr int ticks_a_step = 5;
    static constexpr double step_s = ticks_a_step * tick_s; ///< between steps of the hand
    static constexpr double lag_s = 0.03;                   ///< behind where the hand means to be (assumed)
    static constexpr double strongest_friction_n =
        0.2; ///< at level 1 (assumed: of the order of electrostatic displays)

    /// It is set down at `start`, mm. `manner` is resistance or ticks.
    BareFinger(const Polyline& line, const Person& person, TouchManner manner, double latency_s, Vec2 start);

    /// One step of the hand, which means to be at `meant`, mm: what is felt meanwhile.
    BareTouch move(Vec2 meant);
    Vec2 place() const { return place_; }
    /// To the line, mm.
    double distance() const { return exact_.at(place_).distance; }

private:
    BareTouch tick(Vec2 meant);

    TouchManner manner_;
    double hold_mm_; ///< of the arm's spring, at level 1
    FlatScene scene_;
    ExactLaw exact_;
    FrictionLaw law_;
    FrictionFinger felt_;
    Vec2 place_; ///< mm
    Vec2 drawn_; ///< mm, where the arm would have it without friction
    BareTouch now_;
    std::deque<BareTouch> on_their_way_;
};

} // namespace tp
