// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/base/face.hpp"
#include "faces/base/refinement_stage.hpp"

#include <opencv2/core/mat.hpp>

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>

namespace tp {

/// Which of the nets inside the program find faces and place their points (faces/models/MODELS.md).
struct ExtractorChoice {
    std::string detector = "embedded"; ///< or "yunet"
    std::string model = "embedded";    ///< or "mesh"
    RefinementStage refinement = RefinementStage::onto_edges;
};

/// From a photograph to the contours of its faces, all on this machine. Same bytes in, same contours out.
/// One extractor belongs to one thread at a time.
class FaceExtractor {
public:
    /// An error where nothing has a chosen name, or the nets cannot be used.
    static Result<FaceExtractor> create(const ExtractorChoice& choice = {});
    FaceExtractor(FaceExtractor&&) noexcept;
    FaceExtractor& operator=(FaceExtractor&&) noexcept;
    ~FaceExtractor();

    /// Never throws: what goes wrong is said in the result's `problem`. Another thread may ask it to stop: it
    /// then ends without faces, after the step it is in: the decoder, one look of a net, the edges of a face.
    Extraction extract(const std::filesystem::path& photo, const std::stop_token& stop = {});
    /// The same for a picture already upright in memory, 8-bit BGR.
    Extraction extract(const cv::Mat& picture, const std::stop_token& stop = {});

    /// Why its nets cannot be used, in a sentence; empty: they can. Lets detector and model look once at a blank
    /// picture.
    std::string problem();

private:
    struct Parts;
    explicit FaceExtractor(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

} // namespace tp
