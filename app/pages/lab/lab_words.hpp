// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_replay.hpp"
#include "app/pages/lab/lab_trace.hpp"
#include "app/pages/lab/plot_curves.hpp"
#include "core/geometry/vec.hpp"

#include <QString>

namespace tp {

/// A value of LabParameters with its unit, "0.40 newtons per millimetre".
QString parameter_words(const QString& key, double value);

/// "3.0 mm left, 12.5 mm above of the middle" of the surface.
QString middle_words(Vec2 place);

/// What a plot of the trace shows, as a sentence.
QString plot_words(const LabTrace& trace, TraceQuantity quantity);

/// What computing a recording again has shown.
QString replay_words(const LabReplay& replay);

} // namespace tp
