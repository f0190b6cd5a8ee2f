// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace tp {

/// How far the strongest step of colour beside an outline lies from it: mean over its points, looked for
/// across it within 0.15 `unit_px` to either side, as a fraction of `unit_px` (the distance between the outer
/// corners of the eyes). 0 where the outline lies on the step everywhere, or has fewer than five points.
/// Hair, beards and shadows make it large, and there outlines err: the line itself is not moved by it
/// (docs/decisions/0008-edges-for-lids-and-lips.md). `picture` is 8-bit BGR; what lies outside counts as its
/// border.
double outline_off_step(const cv::Mat& picture, const std::vector<Vec2>& outline, double unit_px);

} // namespace tp
