// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/friction/friction_choices.hpp"
#include "core/guidance/scene.hpp"

#include <QImage>

#include <functional>
#include <stop_token>

namespace tp {

/// A picture so large is still drawn, dots; an electrostatic display of a square metre has fewer.
inline constexpr double most_friction_dots = 4e8;

/// The friction of a moving finger over a surface, for displays whose software takes a picture: 8-bit grey, 0 no friction,
/// 255 all of it, each dot FrictionLaw::moving_level at its middle. True to scale: `dots_per_mm` are written with the
/// picture, whose left upper corner is the surface's; the last column and row may be partly beyond it.
///
/// A sentence where the choices or the size cannot be, or where a ridge would fall between the dots. Null where `stop` was
/// asked for meanwhile. `report` is told how much is drawn, 0 to 1.
Result<QImage> draw_friction_map(const FlatScene& scene, const FrictionChoices& choices,
                                 const Rect& surface_mm, double dots_per_mm, const std::stop_token& stop = {},
                                 const std::function<void(double)>& report = {});

} // namespace tp
