// SPDX-License-Identifier: Apache-2.0
#include "core/friction/friction_law.hpp"

#include "core/guidance/corner_cue.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

/// 0 at 0, ½ at ½, 1 at 1, level at both ends: the cubic that is so.
double eased(double share) { return share * share * (3.0 - 2.0 * share); }

FlatScene as_points(const std::vector<Vec2>& places) {
    FlatScene scene;
    for (const Vec2 place : places) {
        scene.names.emplace_back();
        scene.lines.push_back({{place}, false});
    }
    return scene;
}

} // namespace

FrictionLaw::FrictionLaw(const FlatScene& scene, const FrictionChoices& choices)
    : choices_(choices), per_speed_(1.0 / (choices.moving_mm_s - choices.rest_mm_s)),
      per_half_width_(2.0 / choices.width_mm), stripes_per_mm_(1.0 / choices.texture_mm), lines_(scene),
      corners_(as_points(corners_of(scene)), corner_mm) {
    for (std::size_t contour = 0; contour < scene.lines.size(); ++contour) {
        const bool named =
            std::ranges::find(choices.textured, scene.names[contour]) != choices.textured.end();
        textured_.push_back(static_cast<char>(named && scene.lines[contour].closed));
        has_texture_ |= textured_.back() != 0;
    }
}

double FrictionLaw::ridge(double distance) const noexcept {
    const double share = 1.0 - distance * per_half_width_;
    if (!(share > 0.0))
        return 0.0;
    switch (choices_.ridge) {
    case RidgeShape::flat:
        break;
    case RidgeShape::tent:
        return choices_.strength * share;
    case RidgeShape::rounded:
        return choices_.strength * eased(share);
    }
    return choices_.strength;
}

double FrictionLaw::rough_level(Vec2 place, double distance, bool in_texture) const noexcept {
    const double on_ridge = ridge(distance);
    if (!in_texture || !std::isfinite(place.x))
        return on_ridge;
    const double stripes = place.x * stripes_per_mm_;
    const double from_stripe = std::abs(1.0 - 2.0 * (stripes - std::floor(stripes)));
    return std::max(on_ridge, choices_.texture * eased(from_stripe));
}

} // namespace tp
