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
    paying_.fill(0.0);
    to_pay_ = 0.0;
}

void EnergyObserver::wrote(Vec2 force) noexcept {
    newest_ = (newest_ + 1) % written_.size();
    written_[newest_] = is_finite(force) ? force : Vec2(0.0);
    paying_[newest_] = to_pay_;
    to_pay_ = 0.0;
}

Vec2 EnergyObserver::observe(Vec2 finger, Vec2 velocity, double potential, double dt, double share) noexcept {
    if (!is_finite(finger) || !is_finite(velocity) || !std::isfinite(potential)) {
        reset();
        return Vec2(0.0);
    }
    const auto before = [&](std::size_t ticks) {
        return (newest_ + written_.size() - ticks) % written_.size();
    };
    if (started_) {
        // The force that acted since the last tick was written `delay_` ticks before it.
        const Vec2 step = finger - finger_;
        const double given = glm::dot(written_[before(delay_)], step);
        const double taken = dt > 0.0 ? 1e-3 * limits_.device_damping * glm::dot(step, step) / dt : 0.0;
        leak_ = std::max(0.0, leak_ + given + (potential - potential_) - taken);
    }
    started_ = true;
    finger_ = finger;
    potential_ = potential;

    // What is on its way to the hand will be paid.
    double owed = leak_;
    for (std::size_t ticks = 0; ticks < delay_; ++ticks)
        owed -= paying_[before(ticks)];
    const double speed = length(velocity);
    if (!(speed > limits_.min_speed) || !(dt > 0.0) || !(owed > 0.0) || !(share > 0.0))
        return Vec2(0.0);
    // Damping b takes b v² dt in a tick; in N·s/mm, since mJ = N·mm.
    const double wanted = owed / (speed * speed * dt);
    const double damping = share * std::min(wanted, 1e-3 * limits_.max_damping);
    to_pay_ = damping * speed * speed * dt;
    return -damping * velocity;
}

} // namespace tp
