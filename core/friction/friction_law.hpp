// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/friction/crossing_finder.hpp"
#include "core/friction/friction_choices.hpp"
#include "core/guidance/contour_index.hpp"

#include <vector>

namespace tp {

/// The resistive law: how strongly a surface should hold a bare finger back, by where the finger is and how fast it goes.
///
/// A friction surface can only resist. Electrostatic or ultrasonic, it makes a force against the finger's movement and
/// none where the finger rests, so it cannot draw a finger onto a line as the force laws do, nor push it along one:
/// "an inherently passive device" (Winfield, Glassmire, Colgate, Peshkin, "T-PaD: Tactile Pattern Display through Variable
/// Friction Reduction", World Haptics 2007; Chubb, Colgate, Peshkin, "ShiverPaD: A Glass Haptic Surface That Produces Shear
/// Force on a Bare Finger", IEEE Transactions on Haptics 3, 2010; of electrostatic friction Bau, Poupyrev, Israr, Harrison,
/// "TeslaTouch", UIST 2010). What is here is therefore a level, not a force; its direction is the finger's own.
///
/// Stateless: any number of threads may ask. Allocates nothing, locks nothing, throws nothing.
class FrictionLaw {
public:
    /// `choices` must have no problem. Names that no closed contour has are nothing.
    FrictionLaw(const FlatScene& scene, const FrictionChoices& choices);

    /// Friction level 0 … 1 for a finger that moves, where the nearest line is `distance` ≥ 0 mm away and the place lies in
    /// a textured feature or does not. For a place or a distance that is not a number it is 0.
    double moving_level(Vec2 place, double distance, bool in_texture) const noexcept {
        return in_texture || distance * per_half_width_ < 1.0 ? rough_level(place, distance, in_texture)
                                                              : 0.0;
    }
    /// How much of that a finger feels at this speed, mm/s: 0 at rest … 1, continuous, never falling.
    double share_at(double speed) const noexcept {
        const double share = (speed - choices_.rest_mm_s) * per_speed_;
        return share > 0.0 ? (share < 1.0 ? share : 1.0) : 0.0;
    }
    /// Whether a place (mm, finite) lies in a textured feature. Takes a walk through the scene: not for each sample.
    bool in_texture(Vec2 place) const noexcept { return has_texture_ && lines_.inside(place, textured_); }
    /// Whether crossing this contour leads into a textured feature or out of it.
    bool bounds_texture(int contour) const noexcept {
        return textured_[static_cast<std::size_t>(contour)] != 0;
    }

    /// FrictionChoices::again_mm.
    double again_mm() const noexcept { return choices_.again_mm; }
    const CrossingFinder& lines() const { return lines_; }
    /// Where contours turn sharply, by `corners_of`; found within `corner_mm`.
    const ContourIndex& corners() const { return corners_; }
    static constexpr double corner_mm = 1.5; ///< a finger that comes so near passes a corner

private:
    double rough_level(Vec2 place, double distance, bool in_texture) const noexcept;
    double ridge(double distance) const noexcept;

    FrictionChoices choices_;
    double per_speed_;      ///< s/mm, between resting and moving
    double per_half_width_; ///< 1/mm, of a ridge
    double stripes_per_mm_;
    CrossingFinder lines_;
    std::vector<char> textured_; ///< one a contour: closed, and named
    bool has_texture_ = false;
    ContourIndex corners_;
};

} // namespace tp
