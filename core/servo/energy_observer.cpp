// SPDX-License-Identifier: Apache-2.0
#include "core/servo/energy_observer.hpp"

#include <algorithm>

namespace tp {

EnergyObserver::EnergyObserver(std::size_t delay_ticks, const ObserverLimits& limits)
    : limits_(limits), delay_(std::min(delay_ticks, longest_delay)) {}

void EnergyObserver::reset() noexcept {
    started_ = false;
    leak_ = 0.0;
    written_.fill(Vec2(0.0));
}

void EnergyObserver::wrote(Vec2 force) noexcept {
    newest_ = (newest_ + 1) % written_.size();
    written_[newest_] = is_finite(force) ? force : Vec2(0.0);
}

Vec2 EnergyObserver::observe(Vec2 finger, Vec2 velocity, double potential, double dt) noexcept {
    if (!is_finite(finger) || !is_finite(velocity) || !std::isfinite(potential)) {
        reset();
        return Vec2(0.0);
    }
    if (started_) {
        // The force that acted since the last tick was written `delay_` ticks before it.
        const Vec2 acting = written_[(newest_ + written_.size() - delay_) % written_.size()];
        const double given = glm::dot(acting, finger - finger_);
        leak_ = std::max(0.0, leak_ + given + (potential - potential_));
    }
    started_ = true;
    finger_ = finger;
    potential_ = potential;

    const double speed = length(velocity);
    if (!(speed > limits_.min_speed) || !(dt > 0.0) || leak_ == 0.0)
        return Vec2(0.0);
    // Damping b takes b v² dt in a tick; in N·s/mm, since mJ = N·mm.
    const double wanted = leak_ / (speed * speed * dt);
    const double damping = std::min(wanted, 1e-3 * limits_.max_damping);
    return -damping * velocity;
}

} // namespace tp
