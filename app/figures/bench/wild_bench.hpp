// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/evaluation/wild_labels.hpp"
#include "faces/extract/face_extractor.hpp"

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// A contour that differs more than this is counted, percent of the outer inter-ocular distance.
inline constexpr double much_percent = 5.0;

/// The contours of a face, in the order of the figures about one photograph.
inline constexpr std::array<const char*, 5> wild_contours{
    feature::right_eye, feature::left_eye, feature::outer_lip, feature::inner_lip, feature::outline};

/// What our extraction and the face mesh alone, both with our detector, found in one photograph without
/// truth.
struct WildPhoto {
    std::filesystem::path file;
    std::string name;    ///< of the file, from the folder that was asked for
    std::string problem; ///< why it could not be read, in a sentence; empty: it was
    int faces = 0, mesh_faces = 0;
    int common_faces = 0;          ///< that both found at the same place
    std::vector<std::string> said; ///< Face::problem of each of our faces, the largest first
    int turned_degrees = 0;        ///< clockwise, of the picture in whose pixels the faces below are
    std::optional<Face> face;      ///< the largest of ours
    std::optional<Face> mesh_face; ///< the mesh's at the same place; where we found none, its largest
    ExtractionTimes milliseconds;  ///< of our extraction, one photograph at a time on one core
    /// How far our contours are from the mesh's, as wild_contours, percent of the mesh's outer inter-ocular
    /// distance; nothing where one of both found no face there.
    std::array<std::optional<double>, 5> off_percent{};

    bool was_read() const { return problem.empty(); }
    double worst_percent() const; ///< the largest of off_percent; 0 where there is none
    /// Whether that contour of our largest face may be covered, as the person is told.
    bool is_said_covered(std::size_t contour) const;
};

/// Measures `files` one after the other and hands each to `take`. The names are from `folder`. A sentence where an
/// extractor cannot be made, else empty; a photograph that cannot be read has its own.
std::string run_wild_bench(const std::vector<std::filesystem::path>& files,
                           const std::filesystem::path& folder, const std::function<void(WildPhoto)>& take);

/// Compares what both found in one photograph, in pixels of the same picture: our largest face with the
/// mesh's whose eyes and mouth have their middle within 0.4 of our face's size.
WildPhoto compared(const Extraction& ours, const Extraction& mesh);

/// How far our contours of a kind are from the mesh's, over all photographs; percent as
/// WildPhoto::off_percent.
struct WildAgreement {
    const char* name = "";
    int contours = 0; ///< of eyes two a photograph
    double mean_percent = 0.0;
    double p95_percent = 0.0;        ///< 95 of 100 are within this
    int much_off = 0;                ///< by more than `much_percent`
    std::vector<double> off_percent; ///< of each, the smallest first
};

/// What is said to be covered beside what a person saw, over the photographs with a label, a face of 40 px or
/// more and a face found.
struct WildCovers {
    struct Count {
        int all = 0, said = 0; ///< of those, said that they may be covered
    };
    int photos = 0;
    Count clear_eyes, clear_mouths; ///< not labelled as covered: said is false
    Count covered_eyes, covered_mouths;
    int photos_falsely = 0;           ///< photographs with a false one
    std::vector<std::string> falsely; ///< each false one: "a.jpg: left eye"
    Count without_face; ///< photographs labelled as without a face of 40 px; "said": one was found
    int unlabelled = 0; ///< photographs without a line
};

/// The figures of a set. Photographs labelled as without a face count in `photos`, `unread`, faces, times and
/// `covers` only.
struct WildSummary {
    int photos = 0;
    std::vector<std::string> unread;
    /// Names of photographs in which we, and in which the mesh, found no face.
    std::vector<std::string> not_found, not_found_by_mesh;
    std::vector<std::string> apart; ///< our largest face is none of the mesh's
    int faces = 0, mesh_faces = 0, common_faces = 0;
    int largest_faces = 0;                  ///< photographs with a face of ours
    std::array<WildAgreement, 4> agreement; ///< eyes, outer lip, inner lip, outline
    /// By reason (ContourQuality::reasons): of how many of the largest faces it is said, as wild_contours.
    std::map<std::string, std::array<int, 5>> reasons;
    struct Said {
        int largest = 0, all = 0; ///< of so many largest faces, and of so many of all faces
    };
    std::map<std::string, Said> sentences;       ///< by Face::problem, numbers written as N
    double decode_ms = 0.0, decode_p95_ms = 0.0; ///< median and 95th percentile over the photographs read
    double rest_ms = 0.0, rest_p95_ms = 0.0;     ///< detection, landmarks, edges and contours
    std::optional<WildCovers> covers;            ///< with labels

    int read() const { return photos - static_cast<int>(unread.size()); }
};
/// `labels` may be null.
WildSummary summary_of(const std::vector<WildPhoto>& photos, const WildLabels* labels);

/// Indices into `photos` for a look at the worst: those in which one of both found no face, or not the same
/// one, then those that differ most in one contour. At most `most`; the first kind fills half of it, unless
/// there are too few of the second. What could not be read, and what is labelled as without a face, is left
/// out.
std::vector<std::size_t> worst_of(const std::vector<WildPhoto>& photos, const WildLabels* labels,
                                  std::size_t most);

/// wild.csv in `folder`, a line a photograph, columns named as the fields.
Result<std::filesystem::path> write_wild_table(const std::filesystem::path& folder,
                                               const std::vector<WildPhoto>& photos,
                                               const WildLabels* labels);
/// wild_summary.csv in `folder`: figure, of what, value, unit.
Result<std::filesystem::path> write_wild_summary(const std::filesystem::path& folder,
                                                 const WildSummary& summary);
/// wild.png and .svg in `folder`: the share of contours over how far they are from the mesh's, a line a
/// feature.
Result<std::filesystem::path> plot_wild(const std::filesystem::path& folder, const WildSummary& summary);
/// worst.png in `folder`: a tile for each of `worst`, the face enlarged with both contours.
Result<std::filesystem::path> write_wild_sheet(const std::filesystem::path& folder,
                                               const std::vector<WildPhoto>& photos,
                                               const std::vector<std::size_t>& worst);

} // namespace tp
