// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/study/expression_cues.hpp"
#include "faces/extract/face_extractor.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// What the contours of the faces of one file say.
struct MeasuredFile {
    std::vector<Result<ExpressionCues>> faces; ///< an error where a face lacks what is needed
    std::string
        problem; ///< why there may be too few, or they may be wrong, in a sentence; empty: no reason known
};

/// Takes contours from photographs, through the extraction, and from drawings of contours (SVG), as they are.
class ExpressionMeter {
public:
    /// `use_corrections`: what a person mended beside a photograph stands in place of what is found.
    explicit ExpressionMeter(bool use_corrections) : use_corrections_(use_corrections) {}

    /// An error where the extraction itself cannot work; what is wrong with the file is said in the answer.
    Result<MeasuredFile> measure(const std::filesystem::path& file);

private:
    bool use_corrections_;
    std::optional<FaceExtractor> extractor_; ///< made for the first photograph
};

} // namespace tp
