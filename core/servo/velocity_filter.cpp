// SPDX-License-Identifier: Apache-2.0
#include "core/servo/velocity_filter.hpp"

#include <numbers>

namespace tp {

void VelocityFilter::feed(double time, Vec2 position) noexcept {
    if (!is_finite(position) || !std::isfinite(time))
        return;
    if (!started_) {
        started_ = true;
        velocity_ = Vec2(0.0);
    } else {
        const double dt = time - time_;
        if (!(dt > 0.0))
            return;
        const double share = 1.0 - std::exp(-2.0 * std::numbers::pi * cutoff_ * dt);
        velocity_ += share * ((position - position_) / dt - velocity_);
    }
    time_ = time;
    position_ = position;
}

} // namespace tp
