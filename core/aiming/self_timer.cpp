// SPDX-License-Identifier: Apache-2.0
#include "core/aiming/self_timer.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

namespace {
constexpr double rounding_s = 1e-9; ///< frames' times are sums
}

double SelfTimer::share() const {
    return good_since_ ? std::clamp((last_s_ - *good_since_) / good_for_s, 0.0, 1.0) : 0.0;
}

bool SelfTimer::see(bool good, double now_s) {
    if (!std::isfinite(now_s))
        return false;
    if (good_since_ && (now_s < last_s_ || now_s - last_s_ > longest_unseen_s))
        good_since_.reset();
    last_s_ = now_s;
    if (!good) {
        good_since_.reset();
        taken_ = false;
        return false;
    }
    if (!good_since_)
        good_since_ = now_s;
    if (taken_ || now_s - *good_since_ < good_for_s - rounding_s)
        return false;
    taken_ = true;
    good_since_.reset();
    return true;
}

} // namespace tp
