// SPDX-License-Identifier: Apache-2.0
#include "core/guidance/haptic_scene.hpp"

#include "core/guidance/blended_law.hpp"
#include "core/guidance/corner_cue.hpp"
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

std::unique_ptr<const GuidanceLaw> make_law(const FlatScene& flat, TentProfile profile, LawKind kind,
                                            const Continuity& continuity) {
    if (kind == LawKind::published)
        return std::make_unique<PublishedLaw>(flat, profile);
    std::unique_ptr<const GuidanceLaw> law;
    if (continuity.blend_mm > 0.0)
        law = std::make_unique<BlendedLaw>(flat, profile, continuity.blend_mm);
    else
        law = std::make_unique<ExactLaw>(flat, profile);
    if (continuity.corner_cue)
        law = std::make_unique<CornerCueLaw>(std::move(law), flat, profile);
    return law;
}

double steepest(TentProfile profile, const Continuity& continuity) {
    return profile.stiffness * (1.0 + (continuity.corner_cue ? CornerCueLaw::share_of_stiffness : 0.0));
}

Result<std::unique_ptr<HapticScene>> make_haptic_scene(const Scene& scene, TentProfile profile, LawKind law,
                                                       const Continuity& continuity) {
    if (!profile.valid())
        return Error{"Stiffness and range of the guidance must both be numbers above zero."};
    if (const std::string problem = continuity.problem(); !problem.empty())
        return Error{problem};
    if (law == LawKind::published && !continuity.off())
        return Error{
            "Hysteresis, blending and corner cue belong to the exact law, not to the published one."};
    auto result = std::make_unique<HapticScene>();
    result->flat = flatten(scene);
    result->profile = profile;
    const bool nothing = std::all_of(result->flat.lines.begin(), result->flat.lines.end(),
                                     [](const Polyline& line) { return line.points.empty(); });
    if (nothing)
        return Error{"The scene has no line that can be felt."};
    for (std::size_t i = 0; i < result->flat.lines.size(); ++i)
        for (const Vec2 p : result->flat.lines[i].points)
            if (std::max(std::abs(p.x), std::abs(p.y)) > farthest_felt_mm)
                return Error{
                    "The line " + result->flat.names[i] +
                    " reaches more than 1 km from the middle of the surface, too far to be felt exactly."};
    result->law = make_law(result->flat, profile, law, continuity);
    result->stiffness = steepest(profile, continuity);
    result->hold_mm = continuity.hold_mm;
    return result;
}

} // namespace tp
