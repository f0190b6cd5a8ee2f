// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/feature_tracker.hpp"

#include <limits>

namespace tp {

int FeatureTracker::follow(const FlatScene& scene, Vec2 finger) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    int nearest = -1;
    double nearest_mm = infinity;
    double current_mm = infinity;
    for (std::size_t i = 0; i < scene.lines.size(); ++i) {
        const double distance = distance_to(scene.lines[i], finger);
        if (static_cast<int>(i) == current_)
            current_mm = distance;
        if (distance < nearest_mm) {
            nearest_mm = distance;
            nearest = static_cast<int>(i);
        }
    }
    const bool stays = current_mm <= leave_mm;
    const bool entered = nearest_mm <= enter_mm && (!stays || nearest_mm < current_mm - nearer_by_mm);
    if (entered)
        current_ = nearest;
    else if (!stays)
        current_ = -1;
    return current_;
}

} // namespace tp
