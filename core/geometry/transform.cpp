// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/transform.hpp"

#include <glm/matrix.hpp>

#include <algorithm>

namespace tp {

Result<Affine> Affine::inverse() const {
    const double scale = std::max(length(linear[0]), length(linear[1]));
    if (!std::isfinite(scale) || !is_finite(offset) || !(std::abs(determinant()) > 1e-12 * scale * scale))
        return Error{
            "The map between two frames cannot be inverted, because it flattens the plane to a line."};
    const glm::dmat2 back = glm::inverse(linear);
    return Affine{back, -(back * offset)};
}

Affine compose(const Affine& outer, const Affine& inner) {
    return {outer.linear * inner.linear, outer(inner.offset)};
}

Result<Affine> fit_photo_to_surface(const Rect& subject, const Rect& workspace) {
    if (!(subject.width() > 0.0) || !(subject.height() > 0.0) || !(workspace.width() > 0.0) ||
        !(workspace.height() > 0.0))
        return Error{"A picture and the touch surface both need a width and a height above zero."};
    const double scale = std::min(workspace.width() / subject.width(), workspace.height() / subject.height());
    const glm::dmat2 linear(scale, 0.0, 0.0, -scale);
    const Vec2 offset = workspace.centre() - linear * subject.centre();
    if (!(scale > 0.0) || !std::isfinite(scale) || !is_finite(offset))
        return Error{"The picture or the touch surface is too large or too small to be computed with."};
    return Affine{linear, offset};
}

} // namespace tp
