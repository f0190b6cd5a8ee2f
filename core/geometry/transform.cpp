// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/transform.hpp"

#include <glm/matrix.hpp>

#include <algorithm>
#include <string>

namespace tp {

Result<Affine> Affine::inverse() const {
    const double scale = std::max(length(linear[0]), length(linear[1]));
    if (!std::isfinite(scale) || !is_finite(offset) || !(std::abs(determinant()) > 1e-12 * scale * scale))
        return Error{
            "The map between two frames cannot be turned round, because it flattens the plane to a line."};
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

Result<Calibration> calibrate(const std::vector<FramePair>& pairs, double max_residual_mm) {
    const auto count = static_cast<double>(pairs.size());
    Vec2 device_mean(0.0);
    Vec2 surface_mean(0.0);
    for (const FramePair& pair : pairs) {
        if (!is_finite(pair.device) || !is_finite(pair.surface))
            return Error{"A calibration sample is not a number; touch the marks again."};
        device_mean += pair.device / count;
        surface_mean += pair.surface / count;
    }
    // Normal equations about the means: linear = (Σ s dᵀ)(Σ d dᵀ)⁻¹.
    glm::dmat2 cross_sum(0.0);
    glm::dmat2 device_sum(0.0);
    glm::dmat2 surface_sum(0.0);
    for (const FramePair& pair : pairs) {
        const Vec2 d = pair.device - device_mean;
        const Vec2 s = pair.surface - surface_mean;
        cross_sum += glm::outerProduct(s, d);
        device_sum += glm::outerProduct(d, d);
        surface_sum += glm::outerProduct(s, s);
    }
    // In either frame: marks that the touchscreen saw on one line would fit a map that flattens the plane.
    const auto on_one_line = [](const glm::dmat2& sum) {
        const double spread = sum[0][0] + sum[1][1];
        return !(glm::determinant(sum) > 1e-9 * spread * spread);
    };
    if (pairs.size() < 3 || on_one_line(device_sum) || on_one_line(surface_sum))
        return Error{"Calibration needs at least three marks that do not lie on one line; touch more marks."};
    const glm::dmat2 linear = cross_sum * glm::inverse(device_sum);
    Calibration result{{linear, surface_mean - linear * device_mean}, 0.0};
    double squares = 0.0;
    for (const FramePair& pair : pairs) {
        const Vec2 miss = result.device_to_surface(pair.device) - pair.surface;
        squares += glm::dot(miss, miss);
    }
    result.residual_mm = std::sqrt(squares / count);
    if (!(result.residual_mm <= max_residual_mm)) {
        const auto tenths = [](double mm) {
            const std::string text = std::to_string(std::round(10.0 * mm) / 10.0);
            return text.substr(0, text.find('.') + 2);
        };
        return Error{std::string("The calibration misses its marks by ") + tenths(result.residual_mm) +
                     " mm, more than the " + tenths(max_residual_mm) + " mm allowed; touch them again."};
    }
    return result;
}

} // namespace tp
