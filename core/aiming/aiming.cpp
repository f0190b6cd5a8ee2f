// SPDX-License-Identifier: Apache-2.0
#include "core/aiming/aiming.hpp"

#include <cmath>

namespace tp {

void Aiming::aim_at(Aim aim) {
    adviser_.aim_at(aim);
    pace_.forget();
}

void Aiming::hold(HeldCamera camera) {
    camera_ = camera;
    adviser_.hold(camera);
    adviser_.forget();
    tracks_.forget();
    pace_.forget();
}

AimAnswer Aiming::see(const AimFrame& frame) {
    last_.say.reset();
    last_.take = false;
    if (!std::isfinite(frame.time_s) || !std::isfinite(frame.aspect) || frame.aspect <= 0.0)
        return last_;
    tracks_.see(frame);
    if (tracks_.breaks() != breaks_) {
        breaks_ = tracks_.breaks();
        adviser_.forget();
    }
    last_.now = adviser_.advise(tracks_.faces(), frame);
    last_.good = adviser_.good();
    if (pace_.say(last_.now, adviser_.badness(), frame.time_s))
        last_.say = last_.now;
    last_.tone = aim_tone(adviser_, camera_, pace_.speaking());
    last_.take = timer_.see(last_.good, frame.time_s);
    return last_;
}

} // namespace tp
