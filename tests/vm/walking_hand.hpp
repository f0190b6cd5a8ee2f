// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/polyline.hpp"

#include <cstddef>
#include <utility>

namespace tp::vm {

/// A hand that goes round and round a closed way at a set speed, and stands still when it is told to.
class WalkingHand {
public:
    /// From where the handle is; `speed` in mm/s.
    WalkingHand(Polyline way, Vec2 from, double speed) : way_(std::move(way)), place_(from), speed_(speed) {}

    /// Goes on for `dt` seconds; where it is then, mm.
    Vec2 step(double dt) {
        double left = speed_ * dt;
        for (std::size_t tried = 0; tried < way_.points.size(); ++tried) {
            const Vec2 to = way_.points[next_] - place_;
            const double distance = length(to);
            if (distance > left) {
                place_ += (left / distance) * to;
                break;
            }
            left -= distance;
            place_ = way_.points[next_];
            next_ = (next_ + 1) % way_.points.size();
        }
        return place_;
    }

private:
    Polyline way_;
    Vec2 place_;
    double speed_;
    std::size_t next_ = 0;
};

} // namespace tp::vm
