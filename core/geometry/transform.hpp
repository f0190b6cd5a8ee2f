// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/vec.hpp"

#include <glm/mat2x2.hpp>

namespace tp {

/// Affine map of the plane, x ↦ linear·x + offset: how one frame is seen from another.
struct Affine {
    glm::dmat2 linear{1.0};
    Vec2 offset{0.0};

    Vec2 operator()(Vec2 p) const { return linear * p + offset; }
    /// A direction or difference: the offset does not act.
    Vec2 direction(Vec2 v) const { return linear * v; }
    /// A force felt in the target frame, as it must be applied in the source frame to do the same work, which keeps a
    /// passive field passive: Fₛ·ẋₛ = Fₜ·ẋₜ for every motion, and ẋₜ = linear·ẋₛ, so Fₛ = linearᵀ·Fₜ. Where the map only
    /// turns or mirrors that is its inverse; where it stretches by s the force is s times the target's, and a
    /// stiffness s² times.
    Vec2 pull_back_force(Vec2 force) const { return glm::transpose(linear) * force; }
    /// Factor by which areas grow; negative where the map mirrors.
    double determinant() const { return glm::determinant(linear); }
    /// The map back; an error where the map is singular or not finite.
    Result<Affine> inverse() const;
};

/// First `inner`, then `outer`.
Affine compose(const Affine& outer, const Affine& inner);

/// Photo pixels (x right, y down) → surface millimetres (origin at the centre, x right, y up): the similarity
/// that fits `subject` (pixels, positive width and height) centred into `workspace` (mm), as large as it
/// goes.
Result<Affine> fit_photo_to_surface(const Rect& subject_px, const Rect& workspace_mm);

} // namespace tp
