// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/haptic_scene.hpp"

#include "core/guidance/exact_law.hpp"
#include "core/guidance/published_law.hpp"

#include <algorithm>

namespace tp {

std::optional<LawKind> law_named(std::string_view name) {
    if (name == "exact")
        return LawKind::exact;
    if (name == "published")
        return LawKind::published;
    return std::nullopt;
}

Result<std::unique_ptr<HapticScene>> make_haptic_scene(const Scene& scene, TentProfile profile, LawKind law) {
    if (!profile.valid())
        return Error{"Stiffness and range of the guidance must both be numbers above zero."};
    auto result = std::make_unique<HapticScene>();
    result->flat = flatten(scene);
    result->profile = profile;
    const bool nothing = std::all_of(result->flat.lines.begin(), result->flat.lines.end(),
                                     [](const Polyline& line) { return line.points.empty(); });
    if (nothing)
        return Error{"The scene has no line that can be felt."};
    if (law == LawKind::exact)
        result->law = std::make_unique<ExactLaw>(result->flat, profile);
    else
        result->law = std::make_unique<PublishedLaw>(result->flat, profile);
    return result;
}

} // namespace tp
