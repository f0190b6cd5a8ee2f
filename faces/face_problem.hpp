// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/landmarks.hpp"

#include <opencv2/core/types.hpp>

#include <string>

namespace tp {

/// Why the contours of a found face may be wrong, in a sentence; empty: no reason known.
std::string problem_of(const Detection& face, const Landmarks& points, const cv::Size& picture);

} // namespace tp
