// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// How friction rises from the edge of a ridge to the line in its middle.
enum class RidgeShape {
    flat,   ///< at once, and stays
    tent,   ///< evenly
    rounded ///< first and last slowly, as a cubic: no edge that is felt for itself
};

/// "flat", "tent" or "rounded".
std::optional<RidgeShape> ridge_named(std::string_view name);

/// What of a scene is felt as friction. Widths and speeds were chosen, not measured.
struct FrictionChoices {
    RidgeShape ridge = RidgeShape::rounded;
    double width_mm = 2.0; ///< of a ridge, edge to edge; > 0
    double strength = 1.0; ///< friction level on the line, 0 … 1

    /// Names of closed contours in which a grating is felt: inside an odd number of them, so that "outer_lip" and
    /// "inner_lip" together are the lips without the mouth.
    std::vector<std::string> textured;
    double texture = 0.4;    ///< friction level on a stripe, 0 … 1
    double texture_mm = 2.0; ///< from stripe to stripe, along x; > 0

    double rest_mm_s = 2.0;   ///< up to this speed a finger rests; ≥ 0
    double moving_mm_s = 6.0; ///< from here on it feels all of the friction; > rest_mm_s
    /// A line that was crossed is told of again when the finger has been so far, mm, from where it crossed; ≥ 0. With 0 each
    /// crossing is told.
    double again_mm = 0.0;

    /// The same for a finger whose way is enlarged `scale` times, so that it feels what it does by its own way.
    FrictionChoices enlarged(double scale) const;

    /// A sentence for what cannot be; empty where all is well.
    std::string problem() const;
};

} // namespace tp
