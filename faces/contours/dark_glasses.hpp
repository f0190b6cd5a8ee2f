// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/landmarks.hpp"

#include <opencv2/core/mat.hpp>
#include <opencv2/dnn/dnn.hpp>

#include <optional>

namespace tp {

/// The net that tells dark glasses, which hide the eyes behind them, from clear ones, shadows and eyes that
/// are seen. It is loaded when it is first asked.
class DarkGlasses {
public:
    /// Above 0 where `face` in an 8-bit BGR picture wears them; its size grows with the certainty (a logarithm
    /// of odds). −∞ where the eyes are too near together to be seen, or where there is no picture.
    double evidence(const cv::Mat& picture, const Landmarks& face);

    /// Gives its memory back until it is asked again.
    void rest() { net_.reset(); }

private:
    std::optional<cv::dnn::Net> net_;
};

} // namespace tp
