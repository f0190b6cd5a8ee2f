// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

namespace tp {

/// Velocity from sampled positions: a backward difference through a first-order low-pass. Raw differences are
/// useless for damping (an encoder step of 0.09 mm at 1 kHz reads as 90 mm/s); the cut-off costs a delay of
/// about 1/(2π·cutoff).
class VelocityFilter {
public:
    /// `cutoff` in Hz; > 0.
    explicit VelocityFilter(double cutoff = 40.0) : cutoff_(cutoff) {}

    /// A reading at `time` s, `position` in mm. Readings that are not newer or not finite are ignored.
    void feed(double time, Vec2 position) noexcept;
    /// mm/s
    Vec2 velocity() const noexcept { return velocity_; }

private:
    double cutoff_;
    double time_ = 0.0;
    Vec2 position_{0.0};
    Vec2 velocity_{0.0};
    bool started_ = false;
};

} // namespace tp
