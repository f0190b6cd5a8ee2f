// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace tp {

/// The mean shape that a file of OpenCV's FacemarkLBF holds, 68 points in halves of the box in which it
/// looks, from its middle, eyes level. Nothing where the file is none, or where one of its tables has another
/// size than its header says: FacemarkLBF does not compare them and would read beyond. May throw
/// cv::Exception.
std::optional<std::vector<Vec2>> lbf_mean_shape(const std::filesystem::path& file);

} // namespace tp
