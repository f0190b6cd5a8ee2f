// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/seeing/known_people.hpp"
#include "faces/base/face.hpp"
#include "faces/identity/face_describer.hpp"

#include <opencv2/core/mat.hpp>

#include <memory>
#include <string>
#include <utility>

namespace tp {

/// Says whose face is before the camera, where somebody of the album is surely known by it. What it is known by is forgotten
/// with the call. One thread.
class FaceNamer {
public:
    explicit FaceNamer(std::shared_ptr<const KnownPeople> people) : people_(std::move(people)) {}

    /// `face` of an upright 8-bit BGR picture, with eyes, outer lip and outline. Empty where nobody is known for sure, or the face
    /// is not one to guess from (faces/identity/unfit.hpp). About as long as a describer; nothing where nobody has a name.
    std::string name(const cv::Mat& picture, const Face& face);

private:
    std::shared_ptr<const KnownPeople> people_;
    FaceDescriber describer_; ///< its net is loaded with the first face
};

} // namespace tp
