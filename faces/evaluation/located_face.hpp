// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/contour.hpp"
#include "faces/base/landmarks.hpp"
#include "faces/detect/detector.hpp"
#include "faces/pieces/face_lines.hpp"

#include <opencv2/core/mat.hpp>

#include <optional>
#include <vector>

namespace tp {

/// Where a portrait may show a face, the surest place first; looked for thoroughly where a usual look finds
/// none.
std::vector<Detection> surest_first(Detector& detector, const cv::Mat& picture);

/// The first of `places` that `model` confirms to be a face.
std::optional<Landmarks> located(LandmarkModel& model, const cv::Mat& picture,
                                 const std::vector<Detection>& places);

/// The five contours of `feature` along these lines, every point kept.
std::vector<Contour> contours_of(const FaceLines& lines);

} // namespace tp
