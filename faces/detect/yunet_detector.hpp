// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/detect/detector.hpp"

#include <opencv2/dnn/dnn.hpp>

#include <utility>

namespace tp {

/// YuNet (Wu, Peng, Yu 2023) as OpenCV 4.5.4 to 4.6 run it, with outputs `loc`, `conf` and `iou`.
/// cv::FaceDetectorYN takes a file by its name; this one takes the net that is inside the program.
class YunetDetector : public Detector {
public:
    /// `usual_side`: px, to which a usual look shrinks the longer side of a picture.
    explicit YunetDetector(cv::dnn::Net net, int usual_side = 320)
        : net_(std::move(net)), usual_side_(usual_side) {}
    using Detector::detect;
    /// Throws std::runtime_error where the net's answer does not fit a picture of that size.
    std::vector<Detection> detect(const cv::Mat& picture, Effort effort, Looks& looks,
                                  const std::stop_token& stop) override;

private:
    cv::dnn::Net net_;
    int usual_side_;
};

} // namespace tp
