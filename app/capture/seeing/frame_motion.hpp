// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>

#include <optional>

namespace tp {

/// How fast the picture moves as a whole, from one small frame to the next: phase correlation (Kuglin, Hines 1975), which
/// sees a shift of up to half the picture and does not mind a change of light.
class FrameMotion {
public:
    /// `grey`: 8-bit. Picture widths a second; nothing for the first frame, where the last one was of another size or
    /// `longest_s` ago, and where both have nothing in common.
    std::optional<double> see(const cv::Mat& grey, double time_s);

    static constexpr double longest_s = 1.0;
    /// Share of both frames that is the same picture shifted, below which they have nothing in common: strangers' portraits
    /// reach 0.06, the same one moved by half its width 0.18 and more.
    static constexpr double least_response = 0.1;

private:
    cv::Mat last_, now_, window_;
    double last_s_ = 0.0;
};

} // namespace tp
