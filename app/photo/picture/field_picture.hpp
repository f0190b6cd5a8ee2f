// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/haptic_scene.hpp"

#include <QImage>

#include <functional>
#include <stop_token>
#include <vector>

namespace tp {

/// Draws what a finger would feel: |F| as colour over the surface, arrows along F, the contours, and, where
/// there is one, the way of a finger. A bar shows the colours in newtons and a rule 20 mm.
/// `pixels_per_mm` > 0; a surface wider than 4 000 pixels is drawn smaller. Null where `stop`
/// was asked for meanwhile. `report` is told how much is drawn, 0 to 1.
QImage draw_force_field(const HapticScene& haptic, const Rect& surface_mm, double pixels_per_mm = 5.0,
                        const std::vector<Vec2>& way_mm = {}, const std::stop_token& stop = {},
                        const std::function<void(double)>& report = {});

} // namespace tp
