// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <array>
#include <cstddef>

namespace tp {

/// Velocity of the finger at the time when a force written now acts, and whether such a force takes energy.
///
/// A damping force −b·v that comes late by more than a quarter of a period drives what it should damp. So the
/// velocity is taken over the longest window of readings that lie on a line within the encoder's step (first-order
/// adaptive windowing, Janabi-Sharifi, Hayward, Chen 2000), and carried on over the known delay: the weights of two
/// velocities are fitted, by least squares over the last 25 ms, so that what was said a delay ago is what the
/// finger then did. For a swing of one frequency that is exact. `worth` is how well it did.
class VelocityForecast {
public:
    /// `period` and `delay` in s, from writing a force to its acting; `resolution` in mm, the step of the positions,
    /// 0 where unknown.
    VelocityForecast(double period, double delay, double resolution);

    /// Forgets everything.
    void reset() noexcept;
    /// A new reading, at `time` s, in mm. One that is not newer or not finite is ignored.
    void feed(double time, Vec2 position) noexcept;

    /// mm/s
    Vec2 velocity() const noexcept { return forecast_; }
    /// 0 … 1: share of a damping force that may be written. 0 where its like has lately given energy to the finger.
    double worth() const noexcept { return worth_; }

private:
    static constexpr std::size_t readings = 17;
    static constexpr std::size_t memory = 64;

    Vec2 windowed() const noexcept;
    void learn(Vec2 moved, std::size_t ahead, std::size_t apart, double kept) noexcept;
    /// `back` readings ago.
    const Vec2& past(const std::array<Vec2, memory>& ring, std::size_t back) const noexcept {
        return ring[(newest_ + memory - back) % memory];
    }

    double period_;
    double delay_;
    double resolution_;
    double interval_; ///< s between readings

    std::array<double, readings> times_{};
    std::array<Vec2, readings> places_{};
    std::size_t count_ = 0; ///< readings held
    std::size_t last_ = 0;  ///< where the newest reading is
    std::array<Vec2, memory> seen_{};
    std::array<Vec2, memory> said_{};
    std::size_t newest_ = 0;
    double pp_ = 0.0, pq_ = 0.0, qq_ = 0.0, pv_ = 0.0, qv_ = 0.0, vv_ = 0.0; ///< (mm/s)², sums that fade
    double uu_ = 0.0, uv_ = 0.0;
    Vec2 forecast_{0.0};
    double worth_ = 1.0;
};

} // namespace tp
