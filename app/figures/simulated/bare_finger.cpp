// SPDX-License-Identifier: Apache-2.0
#include "app/figures/simulated/bare_finger.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

BareFinger::BareFinger(const Polyline& line, const Person& person, TouchManner manner, double latency_s,
                       Vec2 start)
    : manner_(manner), hold_mm_(strongest_friction_n / person.stiffness_n_per_mm), scene_{{"line"}, {line}},
      exact_(scene_, {}), law_(scene_, {}), felt_(law_), place_(start), drawn_(start),
      on_their_way_(static_cast<std::size_t>(std::lround(latency_s / tick_s))) {}

BareTouch BareFinger::move(Vec2 meant) {
    BareTouch touch;
    for (int i = 0; i < ticks_a_step; ++i) {
        const BareTouch arrived = tick(meant);
        touch.friction = arrived.friction;
        touch.ticked |= arrived.ticked;
    }
    return touch;
}

BareTouch BareFinger::tick(Vec2 meant) {
    drawn_ += tick_s / lag_s * (meant - drawn_);
    const Vec2 spring = drawn_ - place_;
    const double held = now_.friction * hold_mm_;
    const Vec2 before = place_;
    if (length(spring) > held)
        place_ = drawn_ - held / length(spring) * spring;
    const Friction friction = felt_.step(place_, (place_ - before) / tick_s, exact_.at(place_));
    BareTouch made;
    if (manner_ == TouchManner::resistance)
        made.friction = friction.level;
    else
        made.ticked = std::ranges::any_of(friction.events, [](const LineEvent& event) {
            return event.kind == LineEventKind::crossed && event.share > 0.0;
        });
    on_their_way_.push_back(made);
    now_ = on_their_way_.front();
    on_their_way_.pop_front();
    return now_;
}

} // namespace tp
