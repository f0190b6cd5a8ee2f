// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/detect/detector.hpp"

#include <opencv2/dnn/dnn.hpp>

namespace tp {

/// Our own detector. The net was trained on 160 px squares with faces of 14 … 110 px; being fully
/// convolutional it is shown the picture at several sizes, so that small faces reach that range too: from
/// coarse to fine, until the largest face is so large that a finer look could only show others of less than a
/// quarter of its size. A thorough look ends with one at two fifths of the picture's size, in tiles, for
/// faces of 40 px in a picture of any size.
class EmbeddedDetector : public Detector {
public:
    EmbeddedDetector();
    using Detector::detect;
    std::vector<Detection> detect(const cv::Mat& picture, Effort effort, Looks& looks,
                                  const std::stop_token& stop) override;

private:
    /// Those for the coarse levels, which most pictures need: a net that changes its input size allocates
    /// anew. For a finer look one is made, in a fraction of the time of the look: it holds tens of megabytes.
    std::vector<cv::dnn::Net> nets_;
};

} // namespace tp
