// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/calibration_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tp {

ServoSettings settings_for_reading(ServoSettings settings) {
    settings.limits.stall = 60.0;
    settings.limits.late_periods = 60000.0;
    return settings;
}

bool CalibrationSteps::is_at_mark(Vec2 touched) const {
    const Vec2 off = touched - area_.centre();
    const bool left = mark_ == top_left || mark_ == bottom_left;
    const bool top = mark_ == top_left || mark_ == top_right;
    return (left ? -off.x : off.x) >= corner_share * area_.width() && (top ? off.y : -off.y) >= corner_share * area_.height();
}

void CalibrationSteps::lift() {
    last_.reset();
    rested_.reset();
}

bool CalibrationSteps::sample(Vec2 touched, Vec2 device, double now) {
    const Sample here{{device, touched}, now};
    const std::optional<Sample> before = std::exchange(last_, here);
    if (mark_ == all_touched || !before || !(now > before->time))
        return false;
    const double moved = std::max(length(device - before->pair.device), length(touched - before->pair.surface));
    if (moved > slow_mm_s * (now - before->time)) {
        rested_.reset();
        return false;
    }
    if (now - paired_at_ >= between_s) {
        pairs_.push_back(here.pair);
        paired_at_ = now;
    }
    if (!rested_ || length(touched - rested_->pair.surface) > rest_mm || length(device - rested_->pair.device) > rest_mm)
        rested_ = here;
    if (!is_at_mark(touched) || now - rested_->time < hold_s)
        return false;
    reached_.push_back(here.pair);
    mark_ = static_cast<Mark>(mark_ + 1);
    rested_.reset();
    return true;
}

Result<Calibration> CalibrationSteps::calibration() const {
    Result<Calibration> found = calibrate(pairs_, std::numeric_limits<double>::infinity());
    if (!found || reached_.empty())
        return found;
    double squares = 0.0;
    for (const FramePair& pair : reached_) {
        const double miss = length(found->device_to_surface(pair.device) - pair.surface);
        squares += miss * miss;
    }
    found->residual_mm = std::max(found->residual_mm, std::sqrt(squares / static_cast<double>(reached_.size())));
    return found;
}

} // namespace tp
