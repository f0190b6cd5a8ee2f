// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/touch/touch_output.hpp"

#include <QStringList>

namespace tp {

/// How what an output makes a finger feel stands in JSON: "friction", "ticks", "rumble".
const char* word_of(TouchMeans means);

/// `devices tick`: a touch output is tried. Its words; the exit status.
int tick_touch_output(const QStringList& words);

} // namespace tp
