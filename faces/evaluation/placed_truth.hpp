// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/contour.hpp"

#include <filesystem>
#include <vector>

namespace tp {

/// A photograph and its contours as somebody placed them by hand.
struct PlacedPortrait {
    std::filesystem::path photo;
    std::vector<Contour> truth; ///< the five of `feature`, straight pieces, pixels of the upright picture
};

/// Reads a truth file: JSON, for each photo (relative to `photos`) the points [x, y] of
/// "eye_on_the_left_of_the_picture" (the person's right one), "eye_on_the_right_of_the_picture", "outer_lip",
/// "inner_lip" and "outline". An error where it cannot be read, has more than 16 MB or 8
/// levels, or a photo lacks a contour.
Result<std::vector<PlacedPortrait>> read_placed_truth(const std::filesystem::path& file,
                                                      const std::filesystem::path& photos);

} // namespace tp
