// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/participant/felt_shape.hpp"
#include "core/participant/study_hand.hpp"

#include <array>
#include <span>

namespace tp {

/// How probable each of `shape_corners` is, in their order; together 1.
using ShapeBeliefs = std::array<double, shape_corners.size()>;

/// An error of one standard deviation along a way, which is another one after so many mm: the integral of its autocorrelation.
struct WayError {
    double deviation = 0.0;
    double way_mm = 1.0;
    /// How much a millimetre of the way tells less because of it.
    double loss() const { return deviation * deviation * way_mm; }
};

/// What a piece of the way round a shape tells, long before it is closed: sides and corners, or an even bend. Its places have both errors
/// `places`, in mm, its headings both of `headings`, in degrees. All shapes are as likely before; each is taken at its likeliest size, place and turn, and pays for what it may choose (Schwarz, "Estimating the dimension of a
/// model", Annals of Statistics 6, 1978). Single errors
/// of more than two deviations count as two. All are equal where the way is shorter than 60 mm.
ShapeBeliefs beliefs_of(std::span<const FeltPlace> way, const std::array<WayError, 2>& places,
                        const std::array<WayError, 2>& headings);

} // namespace tp
