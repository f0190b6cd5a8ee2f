// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/detection.hpp"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <stop_token>
#include <vector>

namespace tp {

/// How hard to look.
enum class Effort {
    usual,   ///< for the faces that matter: what is much smaller than the largest may be missed
    thorough ///< for faces as small as can be told at all
};

/// What the looks at one picture showed, for a thorough search to go on from a usual one.
struct Looks {
    std::size_t taken = 0;
    std::vector<Detection> shown; ///< by all of them: the same face may be there several times
};

/// Finds faces in a picture. To add one: derive from this, give it a name in make_detector.
class Detector {
public:
    virtual ~Detector() = default;
    /// Faces in an 8-bit BGR picture of at least 16 × 16 px, in no particular order, none twice.
    /// May throw cv::Exception; the extractor catches it. Where another thread asks it to stop, it ends soon,
    /// with what it has. A thorough search that is given the `looks` of the usual one at the same picture
    /// answers what it would without, but takes none of them again; a detector need not use them.
    virtual std::vector<Detection> detect(const cv::Mat& picture, Effort effort, Looks& looks,
                                          const std::stop_token& stop) = 0;
    /// The same where this is the only search of the picture.
    std::vector<Detection> detect(const cv::Mat& picture, Effort effort, const std::stop_token& stop = {}) {
        Looks none;
        return detect(picture, effort, none, stop);
    }
};

/// Keeps of detections that overlap (intersection over union above `overlap`) only the surest one.
std::vector<Detection> without_doubles(std::vector<Detection> detections, double overlap);

} // namespace tp
