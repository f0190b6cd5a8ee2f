// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/scene.hpp"

#include <string>
#include <vector>

namespace tp {

/// A scene of curves on which speed is weighed against accuracy.
struct AccuracyScene {
    std::string name;
    Scene scene;
};

/// face         the reference face: eyes, lips, outline
/// map          a tactile map: wobbly rings, about 100 000 segments at the usual tolerance
/// adversarial  a spiral of 1.5 mm pitch, cusps, a comb of lines 0.7 mm apart, specks: the nearest
///              contour changes everywhere and curvature has no bound
std::vector<AccuracyScene> accuracy_scenes();

} // namespace tp
