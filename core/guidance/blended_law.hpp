// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/guidance/exact_law.hpp"

#include <array>

namespace tp {

/// The mean of the exact force over a disc round the finger: where the nearest contour changes, the direction
/// turns over the width of the disc instead of jumping.
///
/// A weighted sum of shifted conservative fields is conservative, so this one does no net work round a closed
/// path either, and its potential is the mean of the potentials; blending the direction by a weight of the
/// two distances has none. The places come in opposite pairs, so that beside a straight line, where the
/// force is linear, nothing changes; on a curve of radius R the line moves by less than radius²/(4R). The top
/// of the tent loses about 4/(3π)·K·radius.
class BlendedLaw final : public GuidanceLaw {
public:
    /// `radius_mm` > 0 of the disc.
    BlendedLaw(const FlatScene& scene, TentProfile profile, double radius_mm);

    /// Force and energy are the means; distance, nearest place and contour are the finger's own.
    Guidance at(Vec2 finger) const noexcept override;
    Guidance felt_at(Vec2 finger) const noexcept override;
    Vec2 force_at(Vec2 finger) const noexcept override;

private:
    /// The means, where the finger's own nearest place is that.
    Guidance around(Vec2 finger, const Nearest& nearest) const noexcept;

    static constexpr std::size_t pairs = 12;
    ContourIndex index_;
    TentProfile profile_;
    double radius_;
    std::array<Vec2, 2 * pairs> places_; ///< mm, from the finger
};

} // namespace tp
