// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/base/landmarks.hpp"
#include "faces/evaluation/placed_truth.hpp"
#include "faces/extract/face_extractor.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// The felt features in the order of FeatureIndex.
inline constexpr std::array<const char*, feature_count> felt_features{
    feature::right_eye, feature::left_eye, feature::outer_lip, feature::inner_lip, feature::outline};

/// A contour further off than this is a failure, percent (see contour_error_percent).
inline constexpr double failure_percent = 5.0;

/// How far the contours of one portrait are from those placed by hand.
struct PortraitErrors {
    std::string photo; ///< file name, "002_03.jpg"
    /// contour_error_percent of each of felt_features; nothing where not exactly one face was found.
    std::optional<std::array<double, feature_count>> percent;
    std::string problem; ///< of the extraction, a sentence; empty: none
    ExtractionTimes milliseconds;

    /// Not exactly one face, a problem, or a contour further off than failure_percent.
    bool failed() const;
};

/// One for each of `people`, in their order. An error where the choice cannot be used.
Result<std::vector<PortraitErrors>> measured_errors(const ExtractorChoice& choice,
                                                    const std::vector<PlacedPortrait>& people);

/// Those of read_placed_truth whom the list (see held_out_people) holds out of all training.
Result<std::vector<PlacedPortrait>> held_out_portraits(const std::filesystem::path& list,
                                                       const std::filesystem::path& truth,
                                                       const std::filesystem::path& photos);

} // namespace tp
