// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/earcons.hpp"
#include "fake_loudspeaker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace tp::testing {

/// Of the sounds that were begun since the last call, whether this one is among them; all of them are forgotten.
inline bool heard_earcon(FakeLoudspeaker& speaker, Earcon earcon) {
    speaker.play(1.0);
    const std::vector<float> heard = std::exchange(speaker.heard, {});
    const auto sound = samples_of(earcon);
    return std::search(heard.begin(), heard.end(), sound.begin(), sound.end(),
                       [](float a, float b) { return std::abs(a - b) < 1e-4F; }) != heard.end();
}

} // namespace tp::testing
