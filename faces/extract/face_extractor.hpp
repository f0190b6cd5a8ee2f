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

struct PluggableModel;

/// Which nets to use: "embedded" (ours, inside the program) or the name or file of another model that the
/// user has (faces/models/MODELS.md lists which kinds can be plugged in and where names are looked up).
struct ExtractorChoice {
    std::string detector = "embedded";
    std::string model = "embedded";
    RefinementStage refinement = RefinementStage::onto_edges;
};

/// From a photograph to the contours of its faces, all on this machine. Same bytes in, same contours out.
/// One extractor belongs to one thread at a time.
class FaceExtractor {
public:
    /// An error where a chosen model is missing or cannot be used.
    static Result<FaceExtractor> create(const ExtractorChoice& choice = {});
    FaceExtractor(FaceExtractor&&) noexcept;
    FaceExtractor& operator=(FaceExtractor&&) noexcept;
    ~FaceExtractor();

    /// Never throws: what goes wrong is said in the result's `problem`. Another thread may ask it to stop: it
    /// then ends without faces, after the step it is in: the decoder, one look of a net, the edges of a face.
    Extraction extract(const std::filesystem::path& photo, const std::stop_token& stop = {});
    /// The same for a picture already upright in memory, 8-bit BGR.
    Extraction extract(const cv::Mat& picture, const std::stop_token& stop = {});

private:
    struct Parts;
    explicit FaceExtractor(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

/// Why `file` cannot be used as a model of that kind, in a sentence; empty: it can. Loads it and lets it run
/// once.
std::string problem_with_model(const PluggableModel& model, const std::filesystem::path& file);

} // namespace tp
