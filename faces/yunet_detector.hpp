// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/detector.hpp"

#include <opencv2/objdetect/face.hpp>

#include <filesystem>
#include <memory>

namespace tp {

/// YuNet (Wu, Peng, Yu 2023) by way of OpenCV's FaceDetectorYN; the file is the user's.
class YunetDetector : public Detector {
public:
    /// An error where the file is not a YuNet that this OpenCV can run.
    static Result<std::unique_ptr<Detector>> load(const std::filesystem::path& file);
    explicit YunetDetector(cv::Ptr<cv::FaceDetectorYN> net) : net_(std::move(net)) {}
    using Detector::detect;
    std::vector<Detection> detect(const cv::Mat& picture, Effort effort, Looks& looks,
                                  const std::stop_token& stop) override;

private:
    cv::Ptr<cv::FaceDetectorYN> net_;
};

} // namespace tp
