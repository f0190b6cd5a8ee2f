// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/guidance_law.hpp"

namespace tp {

/// Asks a law at every tick for no more than is felt, and now and then, where nothing pulls, for what is nearest
/// there: a page says where the finger is, and need not know it a thousand times a second.
///
/// Between two looks the contour and its nearest place are those of the last one, and the distance is that to
/// this place: too large by at most twice the way that the finger has gone. One finger has one of these; it
/// allocates nothing.
class FarLook {
public:
    /// Every so many ticks, 50 times a second at 1 kHz.
    static constexpr int ticks = 20;

    Guidance at(const GuidanceLaw& law, Vec2 finger) noexcept {
        Guidance guidance = law.felt_at(finger);
        if (guidance.contour >= 0) {
            left_ = 0;
            return guidance;
        }
        if (left_ == 0) {
            seen_ = law.at(finger);
            left_ = ticks;
        }
        --left_;
        if (seen_.contour < 0)
            return guidance;
        guidance.contour = seen_.contour;
        guidance.segment = seen_.segment;
        guidance.nearest = seen_.nearest;
        guidance.towards = seen_.nearest - finger;
        guidance.distance = length(guidance.towards);
        return guidance;
    }
    /// For another law.
    void reset() noexcept { left_ = 0; }

private:
    Guidance seen_;
    int left_ = 0; ///< ticks until the next look
};

} // namespace tp
