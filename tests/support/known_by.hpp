// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/extract/face_extractor.hpp"
#include "faces/identity/face_describer.hpp"
#include "faces/identity/named_faces.hpp"

#include <opencv2/core/mat.hpp>

#include <string>

namespace tp::test {

/// By what an album knows somebody of whom it has this picture alone, whose face is fit to be known by.
inline NamedFaces known_by(const std::string& name, const cv::Mat& picture) {
    const Extraction found = FaceExtractor::create()->extract(picture);
    FaceDescriber describer;
    return {name, {*descriptor_of(*describer.describe(picture, found.faces.at(0)))}};
}

} // namespace tp::test
