// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/drawn/braked_finger.hpp"

#include <cmath>

namespace tp {

void BrakedFinger::step(Vec2 hand, double level, double seconds) noexcept {
    const Vec2 way = hand - place;
    const double far = length(way);
    const double slack = slack_mm(level);
    if (!(far > slack))
        return;
    const double time_constant = 1e-3 * (hand_damping + viscous * level) / stiffness;
    const double behind = slack + (far - slack) * std::exp(-seconds / time_constant);
    place = hand - behind / far * way;
}

} // namespace tp
