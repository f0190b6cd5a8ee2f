// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/face.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace tp {

/// The contour of that name, or null.
const Contour* contour_named(const std::vector<Contour>& contours, std::string_view name);

/// Distance between the outer corners of the eyes, in the unit of the contours: how far both eyes together
/// reach along the line through their centres. 0 where an eye is missing or both lie in one place.
double outer_inter_ocular_distance(const std::vector<Contour>& contours);

/// How far a prediction is from the truth, percent of the truth's outer inter-ocular distance: both are
/// resampled to 60 points at equal distances; the mean distance of each point to the other line, averaged
/// both ways. The outline, whose ends are a matter of taste, is measured from the truth's points only.
/// Nothing where the contour or an eye is missing.
std::optional<double> contour_error_percent(const std::vector<Contour>& truth,
                                            const std::vector<Contour>& found, std::string_view name);

} // namespace tp
