// SPDX-License-Identifier: Apache-2.0
#include "core/touch/tick_lead.hpp"

#include <algorithm>

namespace tp {

Tick TickLead::step(Vec2 finger, double dt, const TickChoices& choices) noexcept {
    constexpr double click_s = 0.008;
    tour_.step(finger, dt);
    since_ += dt;
    if (tour_.finished() || since_ < every_s)
        return {};
    since_ = 0.0;
    const double away = std::min(1.0, length(tour_.leader() - finger) / reach_mm);
    return {choices.strength * (1.0 - (1.0 - weakest) * away), choices.sharpness, click_s};
}

} // namespace tp
