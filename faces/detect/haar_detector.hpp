// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/detect/detector.hpp"

#include <opencv2/objdetect.hpp>

#include <filesystem>
#include <memory>

namespace tp {

/// A cascade of Haar features for frontal faces by way of OpenCV's CascadeClassifier; the file is the user's.
/// Knows no eyes: they are where they usually lie in its boxes.
class HaarDetector : public Detector {
public:
    /// An error where the file is not such a cascade, or not one that is safe to use.
    static Result<std::unique_ptr<Detector>> load(const std::filesystem::path& file);
    explicit HaarDetector(cv::CascadeClassifier cascade) : cascade_(std::move(cascade)) {}
    using Detector::detect;
    std::vector<Detection> detect(const cv::Mat& picture, Effort effort, Looks& looks,
                                  const std::stop_token& stop) override;

private:
    cv::CascadeClassifier cascade_;
};

} // namespace tp
