// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/friction/friction_law.hpp"
#include "core/guidance/exact_law.hpp"
#include "core/guidance/scene.hpp"

#include <memory>
#include <optional>

namespace tp {

/// What a bare finger is to feel; everything the touch loop needs, made before it is handed over and then never changed.
struct TouchScene {
    TouchScene(FlatScene scene, const FrictionChoices& choices);

    FlatScene flat;
    ExactLaw exact;
    FrictionLaw friction;
    std::optional<Polyline> tour; ///< where the finger is to be led; none: it is free
};

/// An error for choices with a problem, or for a scene without a contour that can be felt.
Result<std::unique_ptr<TouchScene>> make_touch_scene(FlatScene scene, const FrictionChoices& choices = {});

} // namespace tp
