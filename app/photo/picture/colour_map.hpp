// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>

namespace tp {

/// Colour for a share in [0, 1] (clamped; NaN counts as 0): from near black through blue and green to pale
/// yellow, its lightness rising evenly so that it survives a black-and-white print.
QColor field_colour(double share);

/// One clearly distinct colour a contour; repeats after eight.
QColor line_colour(int index);

} // namespace tp
