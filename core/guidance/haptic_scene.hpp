// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/guidance/continuity.hpp"
#include "core/guidance/guidance_law.hpp"
#include "core/guidance/guided_tour.hpp"
#include "core/guidance/scene.hpp"
#include "core/guidance/tent_profile.hpp"

#include <memory>
#include <optional>
#include <string_view>

namespace tp {

enum class LawKind {
    exact,    ///< ExactLaw
    published ///< PublishedLaw
};

/// "exact" or "published", as a shell or a settings page names them.
std::optional<LawKind> law_named(std::string_view name);

/// What one renders and how; everything the servo thread needs, made before it is handed over and then never
/// changed.
struct HapticScene {
    FlatScene flat;
    TentProfile profile;
    std::unique_ptr<const GuidanceLaw> law;
    double stiffness =
        0.0; ///< N/mm, see steepest; 0: unknown, and every change of the force is slowed as a jump
    double hold_mm = 0.0;         ///< hysteresis at switches, which the servo's BranchHold keeps
    std::optional<Polyline> tour; ///< where the finger is to be led; none: it is free
    TourManner tour_manner;
};

/// The law that these choices name; profile and continuity must be valid.
std::unique_ptr<const GuidanceLaw> make_law(const FlatScene& flat, TentProfile profile, LawKind kind,
                                            const Continuity& continuity = {});

/// The most that the force of such a law changes with the place, N/mm, apart from where it jumps.
double steepest(TentProfile profile, const Continuity& continuity = {});

/// No point of a scene lies farther from the middle of the surface on one axis, mm; up to here the index
/// is true to 1e-9 mm.
constexpr double farthest_felt_mm = 1e6;

/// An error for a profile or widths that are not valid, for softened switches of the published law, which has
/// none, for a scene without a contour that can be felt, or for one that reaches beyond `farthest_felt_mm`.
Result<std::unique_ptr<HapticScene>> make_haptic_scene(const Scene& scene, TentProfile profile = {},
                                                       LawKind law = LawKind::exact,
                                                       const Continuity& continuity = {});

} // namespace tp
