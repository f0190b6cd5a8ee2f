// SPDX-License-Identifier: Apache-2.0
#include "app/capture/seeing/frame_motion.hpp"

#include <opencv2/imgproc.hpp>

#include <cmath>

namespace tp {

std::optional<double> FrameMotion::see(const cv::Mat& grey, double time_s) {
    grey.convertTo(now_, CV_32F);
    std::optional<double> motion;
    const double dt = time_s - last_s_;
    if (last_.size() == now_.size() && dt > 0.0 && dt <= longest_s) {
        if (window_.size() != now_.size())
            cv::createHanningWindow(window_, now_.size(), CV_32F);
        double response = 0.0;
        const cv::Point2d shift = cv::phaseCorrelate(last_, now_, window_, &response);
        if (response >= least_response && std::isfinite(shift.x) && std::isfinite(shift.y))
            motion = std::hypot(shift.x, shift.y) / grey.cols / dt;
    }
    cv::swap(last_, now_);
    last_s_ = time_s;
    return motion;
}

} // namespace tp
