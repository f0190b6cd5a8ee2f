// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/scene.hpp"

namespace tp {

/// The shapes that people followed in Experiment I (Lim, Yoo, Choi 2019), in the middle of a surface.
enum class LabShape {
    circle,   ///< radius 40 mm
    triangle, ///< equilateral, 50 mm high
    curve,    ///< open, 200 mm wide
};

Scene sample_scene(LabShape shape, double width_mm, double height_mm);

} // namespace tp
