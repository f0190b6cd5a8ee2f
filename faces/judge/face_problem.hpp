// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/landmarks.hpp"
#include "faces/judge/quality.hpp"

#include <opencv2/core/types.hpp>

#include <string>

namespace tp {

/// Why the contours of a found face may be wrong, in a sentence; empty: no reason known.
std::string problem_of(const Detection& face, const Landmarks& points, const cv::Size& picture);

/// The same from what the extraction tells about the quality: about the contour that is expected to be the
/// worst, if that is 3 % or more and a reason is known.
std::string problem_of(const QualitySigns& signs);

} // namespace tp
