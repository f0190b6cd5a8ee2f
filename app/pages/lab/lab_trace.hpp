// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/tick_tap.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <string>

namespace tp {

/// One tick as the plots show it.
struct TracePoint {
    double time = 0.0;     ///< s since the run began
    double x = 0.0, y = 0.0;   ///< mm
    double fx = 0.0, fy = 0.0; ///< N
    double energy = 0.0;   ///< J that the device has given the hand since the run began; negative: taken from it
    double lateness = 0.0; ///< s by which the tick began later than a period after the one before

    double newtons() const;
};

/// The last ten seconds of a run, and the energy of the whole of it.
///
/// The energy is what a passivity observer sums up (Hannaford & Ryu 2002): Σ F·Δx, with the force that acts while the
/// finger moves. A potential's force gives at most what the potential can store; one that goes on rising is fed by the
/// renderer.
class LabTrace {
public:
    static constexpr double longest = 10.0; ///< s

    /// A new run of a device of this rate, Hz, whose forces act `delay_ticks` ticks after they are written.
    void begin(double rate, std::size_t delay_ticks);
    void add(const TickSample& tick);

    const std::deque<TracePoint>& points() const { return points_; }

    /// Least and most of something in the window; {0, 0} where there is no point.
    struct Range {
        double least = 0.0, most = 0.0;
    };
    template <typename Value>
    Range range(Value value) const {
        if (points_.empty())
            return {};
        Range found{value(points_.front()), value(points_.front())};
        for (const TracePoint& point : points_) {
            found.least = std::min(found.least, value(point));
            found.most = std::max(found.most, value(point));
        }
        return found;
    }

    /// As a table (RFC 4180): time_s, x_mm, y_mm, fx_n, fy_n, energy_j, lateness_s; numbers read back as the same double.
    std::string csv() const;

private:
    double period_ = 0.001;
    std::size_t delay_ = 0;
    double begun_ = 0.0, last_time_ = 0.0; ///< s, servo's clock
    Vec2 last_place_{0.0};
    double energy_ = 0.0;          ///< J
    std::deque<Vec2> forces_;      ///< N, the newest last; one more than the delay
    std::deque<TracePoint> points_;
};

} // namespace tp
