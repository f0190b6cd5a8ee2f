// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/scene.hpp"

namespace tp {

/// Which feature the finger is on, steadily enough to be spoken: it is entered nearer than it is left, and
/// given up for another line only where that one is clearly nearer.
class FeatureTracker {
public:
    static constexpr double enter_mm = 2.5;
    static constexpr double leave_mm = 4.0;
    static constexpr double nearer_by_mm = 1.0;

    /// The index of the contour that the finger is on now; -1 for none.
    int follow(const FlatScene& scene, Vec2 finger);
    int current() const { return current_; }
    /// As if the finger had been on `contour` for some time.
    void set(int contour) { current_ = contour; }

private:
    int current_ = -1;
};

} // namespace tp
