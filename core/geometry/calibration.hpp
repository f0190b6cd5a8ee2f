// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/transform.hpp"
#include "core/geometry/vec.hpp"

#include <cstddef>
#include <vector>

namespace tp {

/// A pair of the same place in both frames, sampled together while a device is calibrated.
struct FramePair {
    Vec2 device{0.0};  ///< mm, the device's own frame
    Vec2 surface{0.0}; ///< mm, the frame of what is touched
};

/// device → surface, and how well it fits.
struct Calibration {
    Affine device_to_surface;
    double residual_mm = 0.0; ///< root mean square over the pairs that were used, in the surface frame
    std::size_t used = 0;     ///< pairs; the others were far off
};

/// A calibration that misses by more is not used: two lines 4 mm apart would be felt in each other's place.
inline constexpr double most_residual_mm = 2.0;

/// The affine map that most pairs agree on: least median of squares over maps through three pairs, then least squares
/// over the pairs within 2.5 robust standard deviations, or 0.5 mm, of it (Rousseeuw and Leroy, Robust Regression and
/// Outlier Detection, 1987, ch. 5). Up to a fifth of the pairs may be anything. The same pairs give the same map.
///
/// An error, with what to do, for pairs that are no places, fewer than three, those that lie on one line in either frame
/// but for a fifth of them, those of which too few agree, and a residual above `max_residual_mm`.
Result<Calibration> calibrate(const std::vector<FramePair>& pairs, double max_residual_mm = most_residual_mm);

} // namespace tp
