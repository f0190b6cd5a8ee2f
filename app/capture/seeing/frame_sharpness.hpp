// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <opencv2/core/mat.hpp>

#include <optional>

namespace tp {

/// How fine what is seen there is, 0 … about 1: squared differences of neighbours over those of places eight times as far
/// apart, in the direction in which that is less. A smear of n neighbours takes it to about 1/n, and neither contrast nor
/// light changes it, but grain in the dark does. A neighbour is 1/1280 of the frame's longer side. `pixels`: 8-bit BGR;
/// `part`: shares of it. Nothing where there is nothing to see (plain, or beside the frame).
std::optional<double> fineness(const cv::Mat& pixels, const Rect& part);

/// Fineness against what this camera showed before: the finest frame of late is 1, and what is remembered of it fades, so
/// that a dirty lens or a soft room does not keep a picture from being taken.
class FrameSharpness {
public:
    /// 0 … 1; nothing where `fine` is nothing. A clock that is set back begins anew.
    std::optional<double> see(std::optional<double> fine, double time_s);

    static constexpr double halves_in_s = 20.0; ///< what is remembered (assumed: longer than one aims)

private:
    double finest_ = 0.0;
    double last_s_ = 0.0;
};

} // namespace tp
