// SPDX-License-Identifier: Apache-2.0
#include "core/servo/velocity_forecast.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

constexpr double memory_s = 0.025;   ///< over which is learnt: two and a half periods at 100 Hz
constexpr double apart_s = 0.003;    ///< between the two velocities; below half a period at 100 Hz
constexpr double least_step = 0.001; ///< mm; a window bends by no less
constexpr double telling = 2.0;      ///< mm/s; slower motion teaches nothing
constexpr double trust = 0.005;      ///< of the velocity as it is, beside what is learnt
constexpr double largest_weight = 3.0;
constexpr double worthless = 0.1;     ///< correlation at which a damping force is no longer written
constexpr double worthwhile = 0.4;    ///< and at which all of it is
constexpr double late_reading = 0.05; ///< s; after that everything is forgotten

} // namespace

VelocityForecast::VelocityForecast(double period, double delay, double resolution)
    : period_(period), delay_(std::max(0.0, delay)), resolution_(std::max(resolution, least_step)),
      interval_(period) {}

void VelocityForecast::reset() noexcept {
    count_ = 0;
    seen_.fill(Vec2(0.0));
    said_.fill(Vec2(0.0));
    pp_ = pq_ = qq_ = pv_ = qv_ = vv_ = uu_ = uv_ = 0.0;
    forecast_ = Vec2(0.0);
    worth_ = 1.0;
}

Vec2 VelocityForecast::windowed() const noexcept {
    const auto reading = [&](std::size_t back) { return (last_ + readings - back) % readings; };
    const double now = times_[last_];
    const Vec2 here = places_[last_];
    Vec2 velocity(0.0);
    for (std::size_t window = 1; window < count_; ++window) {
        const Vec2 slope = (here - places_[reading(window)]) / (now - times_[reading(window)]);
        for (std::size_t i = 1; i < window; ++i) {
            const Vec2 on_the_line = here - (now - times_[reading(i)]) * slope;
            if (length(places_[reading(i)] - on_the_line) > resolution_)
                return velocity;
        }
        velocity = slope;
    }
    return velocity;
}

/// How what was seen and said `ahead` readings ago goes with what the finger has done since the last.
void VelocityForecast::learn(Vec2 moved, std::size_t ahead, std::size_t apart, double kept) noexcept {
    const Vec2 p = past(seen_, ahead - 1);
    const Vec2 q = past(seen_, ahead - 1 + apart);
    const Vec2 u = past(said_, ahead - 1);
    const auto add = [&](double& sum, Vec2 a, Vec2 b) { sum = kept * sum + glm::dot(a, b); };
    add(pp_, p, p);
    add(pq_, p, q);
    add(qq_, q, q);
    add(pv_, p, moved);
    add(qv_, q, moved);
    add(vv_, moved, moved);
    add(uu_, u, u);
    add(uv_, u, moved);
}

void VelocityForecast::feed(double time, Vec2 position) noexcept {
    if (!is_finite(position) || !std::isfinite(time))
        return;
    double passed = count_ > 0 ? time - times_[last_] : 0.0;
    if (count_ > 0 && passed == 0.0)
        return;
    if (passed < 0.0 || passed > late_reading)
        reset();
    const bool first = count_ == 0;
    const Vec2 moved = first ? Vec2(0.0) : (position - places_[last_]) / passed;
    last_ = (last_ + 1) % readings;
    times_[last_] = time;
    places_[last_] = position;
    count_ = std::min(count_ + 1, readings);
    if (first)
        return;

    interval_ += 0.1 * (std::max(passed, period_) - interval_);
    const auto in_readings = [&](double seconds, double most) {
        return static_cast<std::size_t>(std::clamp(std::round(seconds / interval_), 0.0, most));
    };
    const std::size_t ahead = 1 + in_readings(delay_, 24.0);
    const std::size_t apart = std::max<std::size_t>(1, in_readings(apart_s, 16.0));
    const double kept = std::exp(-passed / memory_s);
    learn(moved, ahead, apart, kept);
    newest_ = (newest_ + 1) % memory;
    seen_[newest_] = windowed();

    // (p, q) · weights = v, drawn towards (1, 0), which is the velocity as it is.
    const double steady = telling * telling / (1.0 - kept);
    const double drawn = trust * (pp_ + qq_) + steady;
    const double a = pp_ + drawn;
    const double c = qq_ + drawn;
    const double determinant = a * c - pq_ * pq_;
    const double right_p = pv_ - pp_;
    const double right_q = qv_ - pq_;
    double weight_p = 1.0 + (c * right_p - pq_ * right_q) / determinant;
    double weight_q = (a * right_q - pq_ * right_p) / determinant;
    weight_p = std::clamp(weight_p, -largest_weight, largest_weight);
    weight_q = std::clamp(weight_q, -largest_weight, largest_weight);
    forecast_ = weight_p * seen_[newest_] + weight_q * past(seen_, apart);
    said_[newest_] = forecast_;

    const double correlation = (uv_ + steady) / (std::sqrt(uu_ * vv_) + steady);
    worth_ = std::clamp((correlation - worthless) / (worthwhile - worthless), 0.0, 1.0);
}

} // namespace tp
