// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/polyline.hpp"

#include <QString>

namespace tp {

/// Where a finger is, in the words and numbers that "where am I" is answered with.
struct Whereabouts {
    QString person;      ///< whose face is under the finger or nearest: "Anna", "face 2", "the face"
    bool beside = false; ///< the finger is not on that face
    QString feature;     ///< of the nearest line: "left eye"
    bool on_it = false;  ///< the finger is on that line
    int hour = 12;       ///< to the line; where it is on it, of its place seen from the feature's middle
    int millimetres = 0; ///< to the line; where it is on it, to the feature's middle
};

/// "Anna. Left eye at 2 o'clock, 6 millimetres." On the line: "Anna. On the left eye, at its 2 o'clock, 11 millimetres
/// from its middle." Off the face: "Beside Anna. Face outline at 9 o'clock, 20 millimetres."
QString where_am_i(const Whereabouts& place);

/// 1 … 12 for a direction in the surface frame (12 is away from the person); 12 for none.
int clock_direction(Vec2 direction);

/// The place on a contour where a finger is best set down: the middle of an open line, the beginning of a
/// closed one. The line must have a point.
Vec2 landing_place(const Polyline& line);

} // namespace tp
