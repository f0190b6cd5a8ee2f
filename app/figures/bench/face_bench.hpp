// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/evaluation/placed_truth.hpp"
#include "faces/extract/face_extractor.hpp"

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tp {

/// A way to find contours that is weighed against others.
struct FaceContender {
    /// Detector and model, such as "yunet_and_embedded"; the embedded detector goes without saying.
    std::string name;
    ExtractorChoice choice;
};
/// Our nets, after each of their refinements, then YuNet and the face mesh.
std::vector<FaceContender> face_contenders();

/// What one contender took and how far it was off, at one size of the pictures.
struct FaceBenchRow {
    static constexpr std::array<const char*, 4> features{"eyes", "outer_lip", "inner_lip", "outline"};

    std::string contender;
    int longest_px = 0; ///< of the pictures after scaling; 0: as they are
    int photos = 0;
    int failures = 0; ///< no face found, or a feature more than 5 % off
    /// Medians over the photographs, one at a time on one core, ms.
    double decode_ms = 0.0, detect_ms = 0.0, landmarks_ms = 0.0, edges_ms = 0.0, contours_ms = 0.0;
    /// Means over the photographs with a face, percent of the outer inter-ocular distance, as `features`.
    std::array<double, 4> error_percent{};
    double worst_percent = 0.0; ///< of all features and photographs

    double without_decoding_ms() const { return detect_ms + landmarks_ms + edges_ms + contours_ms; }
    double mean_error_percent() const;
};

/// How many photographs a second a batch takes, files to contours.
struct BatchSpeed {
    std::size_t threads = 0;
    double photos_per_s = 0.0; ///< wall time
};

/// Every contender at every size. An error where one cannot be made or a photograph not be read.
Result<std::vector<FaceBenchRow>> run_face_bench(const std::vector<PlacedPortrait>& portraits,
                                                 const std::vector<FaceContender>& contenders,
                                                 const std::vector<int>& longest_px,
                                                 const std::function<void(const std::string&)>& progress);
/// What one contender made of portraits that were made harder in one way (faces/evaluation/degraded.hpp,
/// opened_mouth.hpp).
struct HarderRow {
    std::string how; ///< "turned 45 % rad"
    std::string contender;
    int photos = 0;
    int found = 0;    ///< of those, with a face
    int failures = 0; ///< no face found, or a feature more than 5 % off
    int said = 0;     ///< of those found, with a problem or a reason why a contour may be wrong
    /// Means over the photographs in which every contender found a face, as FaceBenchRow::features.
    std::array<double, 4> error_percent{};
};
/// Every contender on every portrait in every harder way, way by way; an error as above.
Result<std::vector<HarderRow>> run_harder_bench(const std::vector<PlacedPortrait>& portraits,
                                                const std::vector<FaceContender>& contenders,
                                                const std::function<void(const std::string&)>& progress);

/// The embedded nets over the files, on one thread and on as many as there are cores.
Result<std::vector<BatchSpeed>> run_batch_bench(const std::vector<PlacedPortrait>& portraits);

/// faces.csv in `folder`, columns named as the fields.
Result<std::filesystem::path> write_face_table(const std::filesystem::path& folder,
                                               const std::vector<FaceBenchRow>& rows);
/// harder.csv in `folder`, columns named as the fields.
Result<std::filesystem::path> write_harder_table(const std::filesystem::path& folder,
                                                 const std::vector<HarderRow>& rows);
/// faces.png and .svg in `folder`: milliseconds without decoding over mean error, a line a contender.
Result<std::filesystem::path> plot_faces(const std::filesystem::path& folder,
                                         const std::vector<FaceBenchRow>& rows);

} // namespace tp
