// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/friction/friction_finger.hpp"
#include "core/guidance/exact_law.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tp::testing {

inline constexpr double dt = 0.001;

/// A finger on a scene, moved at a speed, and everything that it was told.
class Walk {
public:
    explicit Walk(const FlatScene& scene, const FrictionChoices& choices = {})
        : exact_(scene, {}), law_(scene, choices), finger_(law_) {}

    /// In a straight line; the first place of all is where the finger is set down.
    void to(Vec2 place, double speed = 80.0) {
        if (!down_) {
            step(place, Vec2(0.0));
            down_ = true;
        }
        const Vec2 from = place_;
        const double way = length(place - from);
        const int steps = std::max(1, static_cast<int>(std::ceil(way / (speed * dt))));
        for (int i = 1; i <= steps; ++i)
            step(from + double(i) / steps * (place - from),
                 way > 0.0 ? speed / way * (place - from) : Vec2(0.0));
    }
    Friction step(Vec2 place, Vec2 velocity) {
        const Friction friction = finger_.step(place, velocity, exact_.at(place));
        events.insert(events.end(), friction.events.begin(), friction.events.end());
        highest = std::max(highest, friction.level);
        place_ = place;
        return friction;
    }
    std::vector<LineEvent> of(LineEventKind kind) const {
        std::vector<LineEvent> list;
        for (const LineEvent& event : events)
            if (event.kind == kind)
                list.push_back(event);
        return list;
    }
    FrictionFinger& finger() { return finger_; }

    std::vector<LineEvent> events;
    double highest = 0.0;

private:
    ExactLaw exact_;
    FrictionLaw law_;
    FrictionFinger finger_;
    bool down_ = false;
    Vec2 place_{0.0};
};

inline const FlatScene line{{"line"}, {{{{-40, 0}, {40, 0}}, false}}};

} // namespace tp::testing
