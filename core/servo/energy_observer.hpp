// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <array>
#include <cstddef>

namespace tp {

/// Bounds on what the observer may do.
struct ObserverLimits {
    double max_damping = 8.0; ///< N·s/m; more would shake at a delay of a few ticks
    double min_speed = 0.5;   ///< mm/s; below it there is nothing to damp
    double device_damping = 0.0; ///< N·s/m, of the device itself, which takes its part of the leak
};

/// Time-domain passivity observer with the exact potential as its reference (Hannaford & Ryu 2002; Ryu,
/// Preusche, Hannaford, Hirzinger 2005).
///
/// A sampled and delayed spring gives the hand a little more energy than its potential lost: the leak, about
/// K (T/2 + nT) v² a second. U is known in closed form here, so the leak is what the force has done to the
/// hand plus what U has gained. It is paid back by a damping force along the velocity. Where the renderer
/// takes energy (the outer slope of the tent) no credit is kept: credit is what lets a released handle swing
/// for ever.
class EnergyObserver {
public:
    static constexpr std::size_t longest_delay = 16; ///< ticks

    /// `delay_ticks` whole ticks pass between writing a force and its acting; clamped to longest_delay.
    explicit EnergyObserver(std::size_t delay_ticks = 0, const ObserverLimits& limits = {});

    /// Forgets everything, as when the scene or the gain changes.
    void reset() noexcept;

    /// One tick: where the finger is (mm), its velocity when a force of this tick acts (mm/s), the potential there
    /// (mJ). Returns the force that pays the leak back, N: `share` of it where damping takes only so much.
    Vec2 observe(Vec2 finger, Vec2 velocity, double potential, double dt, double share = 1.0) noexcept;
    /// The force that was written in this tick, N; after `observe`.
    void wrote(Vec2 force) noexcept;

    /// Energy given to the hand beyond the potential and not yet paid back, mJ; never negative.
    double leak() const noexcept { return leak_; }

private:
    ObserverLimits limits_;
    std::size_t delay_;
    std::array<Vec2, longest_delay + 1> written_{};  ///< ring of the last forces
    std::array<double, longest_delay + 1> paying_{}; ///< mJ, what each of them is to pay back
    double to_pay_ = 0.0;                            ///< mJ, of the force of this tick
    std::size_t newest_ = 0;
    bool started_ = false;
    Vec2 finger_{0.0};
    double potential_ = 0.0;
    double leak_ = 0.0;
};

} // namespace tp
