// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

namespace tp {

/// Velocity from sampled positions: a backward difference through a first-order low-pass. Raw differences are
/// useless for damping (an encoder step of 0.09 mm at 1 kHz reads as 90 mm/s); the cut-off costs a delay of
/// about 1/(2π·cutoff).
///
/// A velocity does not outlive its readings: once the next one is overdue, which is after twice the time
/// between the last two, it falls as the low-pass does, and after `longest_silence` there is none.
class VelocityFilter {
public:
    static constexpr double longest_silence = 0.020; ///< s
    static constexpr double longest_wait = 0.010;    ///< s; a reading that is later than this is overdue

    /// `cutoff` in Hz; > 0.
    explicit VelocityFilter(double cutoff = 40.0) : cutoff_(cutoff) {}

    /// A reading at `time` s, `position` in mm. Readings that are not newer or not finite are ignored.
    void feed(double time, Vec2 position) noexcept;
    /// It is `now`, s, of any clock that does not go back: once in each tick, after what the tick has fed.
    void elapse(double now) noexcept;
    /// mm/s
    Vec2 velocity() const noexcept { return left_ * velocity_; }
    /// 0 … 1: share of a velocity that the readings' age leaves.
    double share_left() const noexcept { return left_; }

private:
    double cutoff_;
    double time_ = 0.0;
    Vec2 position_{0.0};
    Vec2 velocity_{0.0};
    bool started_ = false;
    double interval_ = 0.0; ///< s between the last two readings
    bool fed_ = false;      ///< since `elapse`
    double fed_at_ = 0.0;   ///< s, the clock of `elapse`
    double left_ = 1.0;     ///< share of the velocity that an overdue reading leaves
};

} // namespace tp
