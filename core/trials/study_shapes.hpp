// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/contour.hpp"

#include <optional>
#include <string_view>

namespace tp {

/// The lines that the published experiments put before a finger (Lim, Yoo, Choi 2019), in mm.
enum class StudyShape { circle, triangle, square, pentagon, hexagon, curve, line, broken_line };

/// "circle" … "broken-line", as experiments spell them.
std::optional<StudyShape> study_shape_named(std::string_view name);

/// How large a shape is where an experiment does not say: the radius of the circle round it, mm. A circle of 4 cm radius, a triangle
/// of 5 cm height, a curve 20 cm wide, and so are the lines of training; 5 cm for the others.
double usual_radius_mm(StudyShape shape);

/// A shape about `centre`, of the circle of `radius_mm` > 0 round it, with a level side at its foot. `first` says where the contour
/// begins: a share of the way round a circle, the number of a polygon's corner (counted modulo its corners), or which end of the
/// curve, or of a line. The circle is four cubics, within 0.03 % of its radius; the curve is one wave of two cubics as wide as the
/// circle round it, and the broken line has one right angle, since the published text has no formula of its own.
Contour study_shape(StudyShape shape, Vec2 centre, double radius_mm, double first = 0.0);

} // namespace tp
