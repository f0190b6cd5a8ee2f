// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <opencv2/core/mat.hpp>

#include <algorithm>
#include <stop_token>
#include <vector>

namespace tp {

/// A place where a detector sees a face, in pixels of the picture it was shown.
struct Detection {
    Rect box;            ///< the head without hair
    Vec2 right_eye{0.0}; ///< centre of the person's own right eye, left in the picture
    Vec2 left_eye{0.0};  ///< centre of the other eye
    double score = 0.0;  ///< 0 … 1

    double size() const { return std::max(box.width(), box.height()); }
};

/// How hard to look.
enum class Effort {
    usual,   ///< for the faces that matter: what is much smaller than the largest may be missed
    thorough ///< for faces as small as can be told at all
};

/// Finds faces in a picture. To add one: derive from this, give it a name in make_detector.
class Detector {
public:
    virtual ~Detector() = default;
    /// Faces in an 8-bit BGR picture of at least 16 × 16 px, in no particular order, none twice.
    /// May throw cv::Exception; the extractor catches it. Where another thread asks it to stop, it ends soon,
    /// with what it has.
    virtual std::vector<Detection> detect(const cv::Mat& picture, Effort effort,
                                          const std::stop_token& stop = {}) = 0;
};

/// Keeps of detections that overlap (intersection over union above `overlap`) only the surest one.
std::vector<Detection> without_doubles(std::vector<Detection> detections, double overlap);

} // namespace tp
