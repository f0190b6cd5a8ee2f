// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/command_line.hpp"
#include "core/guidance/haptic_scene.hpp"

#include <memory>

namespace tp {

/// The options that every verb with a force has: --law, --stiffness, --range, --blend, --corner-cue.
void add_guidance_options(VerbLine& line);

struct GuidanceOptions {
    LawKind law = LawKind::exact;
    TentProfile profile;
    Continuity continuity;
};
Result<GuidanceOptions> guidance_options(const VerbLine& line);

/// A scene file, read and made ready to be felt.
struct LoadedScene {
    Scene scene;
    std::unique_ptr<HapticScene> haptic;
};
Result<LoadedScene> load_scene(const QString& file, const GuidanceOptions& options);

} // namespace tp
