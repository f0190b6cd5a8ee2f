// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/guide/sonar_cue.hpp"
#include "core/aiming/aim_tone.hpp"

namespace tp {

/// How the tone of aiming sounds: as the sonar does, where what is led is the hand with the camera. `waited`: how much of the
/// wait for the picture is over, 0 … 1, by which the tone rises where all is well.
SonarCue aim_cue(const AimTone& tone, double waited);

} // namespace tp
