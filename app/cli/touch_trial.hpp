// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/touch_registry.hpp"

#include <QStringList>

#include <vector>

namespace tp {

/// How what an output makes a finger feel stands in JSON: "friction", "ticks", "rumble".
const char* word_of(TouchMeans means);

/// What a bare finger can feel now: by the registry, and by the session's vibration service.
std::vector<ListedTouchOutput> touch_outputs_here();

/// `devices tick`: a touch output is tried. Its words; the exit status.
int tick_touch_output(const QStringList& words);

} // namespace tp
