// SPDX-License-Identifier: Apache-2.0
#include "core/study/finger_touch.hpp"

namespace tp {

ExpressionCues felt(ExpressionCues cues, const FingerTouch& touch, std::mt19937_64& random) {
    for (const Cue gap : {Cue::mouth_opening, Cue::eye_opening})
        if (at(cues, gap) < touch.percent(touch.told_apart_mm))
            at(cues, gap) = 0.0;
    std::normal_distribution<double> error;
    for (std::size_t i = 0; i < cue_count; ++i)
        cues[i] += touch.noise_of(i) * error(random);
    return cues;
}

} // namespace tp
