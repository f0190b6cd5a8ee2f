// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace tp {

/// When a word about long work is worth saying: at each quarter of it, and after a minute in which nothing was said, but
/// never within five seconds of the last word.
class ImportPace {
public:
    /// `fraction` done, 0–1; `now_s` by a clock that began with the work. Whether to speak now.
    bool due(double fraction, double now_s) {
        const double known = std::isnan(fraction) ? 0.0 : std::clamp(fraction, 0.0, 1.0);
        const int quarter = static_cast<int>(std::floor(4.0 * known));
        const bool further = quarter > told_quarter_ && quarter < 4; // its end is told by the report
        const double silent_s = now_s - told_s_;
        if (silent_s < shortest_silence_s || (!further && silent_s < longest_silence_s))
            return false;
        told_quarter_ = std::max(told_quarter_, quarter);
        told_s_ = now_s;
        return true;
    }

    static constexpr double shortest_silence_s = 5.0;
    static constexpr double longest_silence_s = 60.0;

private:
    int told_quarter_ = 0;
    double told_s_ = 0.0;
};

} // namespace tp
