// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/guided_tour.hpp"

#include <algorithm>

namespace tp {

GuidedTour::GuidedTour(const Polyline& path, Vec2 finger, TourManner manner)
    : path_(path), manner_(manner), total_(length_of(path)), start_(nearest_arc(path, finger)),
      direction_(1.0), leader_(finger) {
    if (!path.closed) {
        const bool from_the_end = length(finger - path.points.back()) < length(finger - path.points.front());
        start_ = from_the_end ? total_ : 0.0;
        direction_ = from_the_end ? -1.0 : 1.0;
    }
}

double GuidedTour::progress() const {
    if (phase_ == Phase::done)
        return 1.0;
    return total_ > 0.0 ? std::clamp(walked_ / total_, 0.0, 1.0) : 0.0;
}

void GuidedTour::advance(double way) noexcept {
    if (phase_ == Phase::approach) {
        const Vec2 begin = point_along(path_, start_);
        const double left = length(begin - leader_);
        if (left > way) {
            leader_ += (way / left) * (begin - leader_);
            return;
        }
        way -= left;
        leader_ = begin;
        phase_ = Phase::walk;
    }
    walked_ = std::min(walked_ + way, total_);
    leader_ = point_along(path_, start_ + direction_ * walked_);
}

Vec2 GuidedTour::step(Vec2 finger, double dt) noexcept {
    if (phase_ == Phase::done || !is_finite(finger))
        return Vec2(0.0);
    const double behind = length(leader_ - finger);
    if (behind < manner_.max_lead)
        advance(manner_.speed * std::max(0.0, dt));
    if (phase_ == Phase::walk && walked_ >= total_ && behind < 0.25 * manner_.max_lead) {
        phase_ = Phase::done;
        return Vec2(0.0);
    }
    const double distance = length(leader_ - finger);
    if (!(distance > 0.0))
        return Vec2(0.0);
    const double magnitude = std::min(manner_.stiffness * distance, manner_.max_force);
    return (magnitude / distance) * (leader_ - finger);
}

} // namespace tp
