// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace tp {

inline constexpr double good_for_s = 0.8;        ///< of good frames before the picture is taken
inline constexpr double longest_unseen_s = 0.35; ///< between two good frames; what lies between was not seen

/// When the shutter acts by itself: after the frame was good for a while, once, until it was bad or `arm` was called.
class SelfTimer {
public:
    /// True where the picture is to be taken now. A clock that is set back begins the wait anew.
    bool see(bool good, double now_s);
    /// The next picture may come without a bad frame before it.
    void arm() { taken_ = false; }
    /// How much of the wait is over, 0 … 1.
    double share() const;

private:
    std::optional<double> good_since_; ///< s
    double last_s_ = 0.0;
    bool taken_ = false;
};

} // namespace tp
