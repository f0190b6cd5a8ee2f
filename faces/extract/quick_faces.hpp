// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/detection.hpp"
#include "faces/base/face.hpp"

#include <opencv2/core/mat.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace tp {

/// Where faces are, many times a second: for who aims a camera, not for who wants contours. With nets of its own; one thread.
class QuickFaces {
public:
    QuickFaces();
    QuickFaces(QuickFaces&&) noexcept;
    QuickFaces& operator=(QuickFaces&&) noexcept;
    ~QuickFaces();

    /// Places that the embedded detector sees in an 8-bit BGR picture of at least 16 × 16 px, one a head, the largest first;
    /// nothing confirms them. Of 320 px a few ms. May throw cv::Exception.
    std::vector<Detection> find(const cv::Mat& picture);
    /// Both eyes of that face of `picture` are shut, as far as its points are sure. A face of 70 px and more is large enough;
    /// takes three times as long as finding it. May throw cv::Exception.
    bool eyes_shut(const cv::Mat& picture, const Detection& face);
    /// That face of `picture` with eyes, outer lip and outline as lines through the nets' points: enough to know somebody by, not to
    /// be felt. Nothing where the points are not sure. As long as `eyes_shut`. May throw cv::Exception.
    std::optional<Face> face_at(const cv::Mat& picture, const Detection& face);

private:
    struct Nets;
    std::unique_ptr<Nets> nets_;
};

} // namespace tp
