// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/polyline.hpp"

namespace tp {

/// How a finger is led.
struct TourManner {
    double speed = 30.0;    ///< mm/s along the feature
    double stiffness = 0.2; ///< N/mm between the finger and the place that leads it
    double max_force = 0.8; ///< N
    double max_lead = 8.0;  ///< mm; the leading place waits for a finger that is farther behind
};

/// Leads the finger once along a feature at a set speed with a bounded force, then lets go.
///
/// A closed feature is walked once round from the place nearest to the finger; an open one from its nearer
/// end to the other. First the finger is led straight to where the walk begins. Only `step` changes the
/// state, and it allocates nothing.
class GuidedTour {
public:
    /// `path` in mm and with at least one point; it must outlive the tour.
    GuidedTour(const Polyline& path, Vec2 finger, TourManner manner = {});

    /// Moves the leading place on by `dt` seconds and returns the force on the finger, N.
    Vec2 step(Vec2 finger, double dt) noexcept;
    /// The finger has arrived at the end; from here on the force is zero.
    bool finished() const { return phase_ == Phase::done; }
    /// Share of the whole way done, 0 … 1.
    double progress() const;
    /// The place that leads the finger, mm.
    Vec2 leader() const { return leader_; }

private:
    enum class Phase { approach, walk, done };
    void advance(double way) noexcept;

    const Polyline& path_;
    TourManner manner_;
    double total_;     ///< length of the walk, mm
    double start_;     ///< arc where it begins, mm
    double direction_; ///< +1 or -1 along the path
    double walked_ = 0.0;
    Vec2 leader_;
    Phase phase_ = Phase::approach;
};

} // namespace tp
