// SPDX-License-Identifier: Apache-2.0
#include "core/touch/touch_scene.hpp"

#include <string>
#include <utility>

namespace tp {

TouchScene::TouchScene(FlatScene scene, const FrictionChoices& choices)
    : flat(std::move(scene)), exact(flat, {}), friction(flat, choices) {}

Result<std::unique_ptr<TouchScene>> make_touch_scene(FlatScene scene, const FrictionChoices& choices) {
    if (const std::string problem = choices.problem(); !problem.empty())
        return Error{problem};
    auto made = std::make_unique<TouchScene>(std::move(scene), choices);
    if (made->friction.lines().segment_count() == 0)
        return Error{"The scene has no line that can be felt."};
    return made;
}

} // namespace tp
