// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/scene.hpp"

#include <QString>

namespace tp {

/// The answer to "where am I": "On the left eye." where the finger is on contour `feature`, else which line
/// is nearest, in which direction of a clock face (12 is away from the person) and how many millimetres away.
QString where_am_i(const FlatScene& scene, Vec2 finger, int feature);

/// 1 … 12 for a direction in the surface frame; 12 for none.
int clock_direction(Vec2 direction);

/// The place on a contour where a finger is best set down: the middle of an open line, the beginning of a
/// closed one. The line must have a point.
Vec2 landing_place(const Polyline& line);

} // namespace tp
