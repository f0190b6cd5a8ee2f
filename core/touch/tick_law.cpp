// SPDX-License-Identifier: Apache-2.0
#include "core/touch/tick_law.hpp"

#include <cmath>

namespace tp {

Tick tick_of(const LineEvent& event, const TickChoices& choices) noexcept {
    constexpr double click_s = 0.008;
    constexpr double bump_s = 0.016;
    const double strength = choices.strength * event.share;
    switch (event.kind) {
    case LineEventKind::crossed:
        return {strength, choices.sharpness * std::sin(event.angle), click_s};
    case LineEventKind::followed:
        return {0.5 * strength, 0.0, bump_s};
    case LineEventKind::left:
        return {strength, 1.0, bump_s};
    case LineEventKind::corner:
        return {2.0 / 3.0 * strength, choices.sharpness, click_s};
    }
    return {};
}

Tick tick_of(const Friction& friction, const TickChoices& choices) noexcept {
    Tick strongest;
    for (const LineEvent& event : friction.events) {
        const Tick tick = tick_of(event, choices);
        if (tick.amplitude() > strongest.amplitude())
            strongest = tick;
    }
    return strongest;
}

} // namespace tp
