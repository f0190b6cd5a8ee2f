// SPDX-License-Identifier: Apache-2.0
#include "core/servo/velocity_filter.hpp"

#include <algorithm>
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
        interval_ = dt;
    }
    time_ = time;
    position_ = position;
    fed_ = true;
    left_ = 1.0;
}

void VelocityFilter::elapse(double now) noexcept {
    if (fed_) {
        fed_ = false;
        fed_at_ = now;
        return;
    }
    const double silent = now - fed_at_;
    const double overdue = silent - std::min(2.0 * interval_, longest_wait);
    left_ = overdue > 0.0 ? std::exp(-2.0 * std::numbers::pi * cutoff_ * overdue) : 1.0;
    if (silent > longest_silence) {
        velocity_ = Vec2(0.0);
        left_ = 0.0;
    }
}

} // namespace tp
