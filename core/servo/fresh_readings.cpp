// SPDX-License-Identifier: Apache-2.0
#include "core/servo/fresh_readings.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

bool FreshReadings::follows(const Reading& before, const Reading& next) noexcept {
    const double by_device = next.stamp - before.stamp;
    const double by_servo = next.arrival - before.arrival;
    return by_device > 0.0 && std::abs(by_device - by_servo) <= jitter + drift * std::max(0.0, by_servo);
}

void FreshReadings::calm_down(double now) noexcept {
    restless_ = std::max(0.0, restless_ - jumps * std::max(0.0, now - calmed_at_));
    calmed_at_ = now;
}

/// One that does not follow the last reading: true where enough have gone on in the way that it does.
bool FreshReadings::confirms(const Reading& reading) noexcept {
    constexpr double most_restless = 32.0; // readings until a clock that is in order is believed again
    const bool goes_on = unlikely_ && follows(*unlikely_, reading);
    confirmed_ = goes_on ? confirmed_ + 1 : 0;
    if (!goes_on)
        restless_ = std::min(restless_ + 1.0, most_restless);
    unlikely_ = reading;
    return goes_on && confirmed_ >= restless_ - 1.0;
}

std::optional<double> FreshReadings::taken(double stamp, double now) noexcept {
    if (!std::isfinite(stamp) || !std::isfinite(now))
        return std::nullopt;
    const Reading reading{stamp, now};
    calm_down(now);
    const bool first = !last_;
    if (!first && (stamp == last_->stamp || (unlikely_ && stamp == unlikely_->stamp)))
        return std::nullopt;
    if (!first && follows(*last_, reading))
        offset_ = std::min(offset_ + drift * std::max(0.0, now - last_->arrival), now - stamp);
    else if (first || confirms(reading))
        offset_ = now - stamp;
    else
        return std::nullopt;
    last_ = reading;
    unlikely_.reset();
    const double taken = std::min(stamp + offset_, now);
    if (now - taken > longest_lag_ || (!first && !(taken > taken_)))
        return std::nullopt;
    return taken_ = taken;
}

} // namespace tp
