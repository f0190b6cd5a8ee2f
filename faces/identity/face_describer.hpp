// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/face.hpp"
#include "faces/identity/descriptor.hpp"

#include <opencv2/core/mat.hpp>

#include <memory>
#include <optional>

namespace tp {

/// Describes faces by numbers that are near each other where two faces are the same person's. The net is loaded
/// with the first face and takes 45 MB then. A describer belongs to one thread at a time.
class FaceDescriber {
public:
    FaceDescriber();
    ~FaceDescriber();

    /// Of a face in an upright 8-bit BGR picture, by its contours. Nothing where these are missing, or OpenCV
    /// refuses. A soft face is sharpened first (sharpened.hpp), but for one that is too small to guess from: sharpened it
    /// shows its pixels. The same pixels give the same numbers. Whether a name may be guessed from them: unfit.hpp.
    std::optional<FaceNumbers> describe(const cv::Mat& picture, const Face& face);
    /// The same of a picture of face_square_px, as face_square makes it.
    std::optional<FaceNumbers> describe_square(const cv::Mat& square);

private:
    struct Net;
    std::unique_ptr<Net> net_;
};

} // namespace tp
