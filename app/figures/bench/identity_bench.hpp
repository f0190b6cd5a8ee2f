// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/identity/descriptor.hpp"
#include "faces/identity/unfit.hpp"

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tp {

inline constexpr const char* as_it_is = "as it is"; ///< how portraits are that nothing was done to

/// One portrait of somebody, as it is or made harder in one way, and what is known of its largest face.
struct DescribedPortrait {
    std::string person; ///< what stands in the file's name before the first _
    std::string photo;  ///< file name
    std::string how;    ///< "as it is", "face 40 px", "turned 45 % rad"
    bool found = false; ///< a face
    Unfit unfit = Unfit::no_contours;
    FaceNumbers numbers{};
};

/// What a way of making portraits harder does to telling people apart. Pairs are of two portraits: the first one of
/// each person as it is, the others made harder.
struct IdentityRow {
    std::string how;
    int portraits = 0, found = 0;
    int unfit = 0; ///< of those found, from which nobody should guess
    int genuine_pairs = 0, impostor_pairs = 0;
    double genuine = 0.0, impostor = 0.0; ///< mean distances
    double equal_error_percent = 0.0;
    double true_accepts_percent = 0.0;     ///< where one impostor in a thousand is accepted
    double threshold = 0.0;                ///< the distance at which that is
    double both_equal_error_percent = 0.0; ///< where both portraits are made harder
};

/// How the portraits as they are, those that are fit, fall into groups.
struct IdentityGroups {
    int people = 0, faces = 0, groups = 0;
    double purity = 0.0; ///< share of faces that are with most of their group's
    double groups_a_person() const { return people > 0 ? static_cast<double>(groups) / people : 0.0; }
};

struct IdentityBench {
    std::vector<DescribedPortrait> portraits;
    double describe_ms = 0.0; ///< of a face, contours to numbers, processor time of one core: median
};

/// Describes each of `files` as it is, in each way of faces/evaluation/harder_ways.hpp, and with its face 60, 40 and 25
/// px large; ends before the next one once `stop` is true. An error where the nets cannot be used or a photograph not
/// be read.
Result<IdentityBench> run_identity_bench(const std::vector<std::filesystem::path>& files,
                                         const std::function<void(const std::string&)>& progress,
                                         const std::atomic<bool>& stop);

/// Processor time of a face that is added, ms, where `faces` of drawn people are known: the mean over the last tenth of
/// them. Of `people`; with as many as faces no two are one person's.
double face_adding_ms(std::size_t faces, std::size_t people);

/// A row for each way, in the order in which they first come.
std::vector<IdentityRow> identity_rows(const std::vector<DescribedPortrait>& portraits);
IdentityGroups identity_groups(const std::vector<DescribedPortrait>& portraits);

/// Rates of two heaps of distances, none of them empty.
struct ErrorRates {
    double equal_error_percent = 0.0;
    double true_accepts_percent = 0.0, threshold = 0.0; ///< see IdentityRow
};
ErrorRates error_rates(std::vector<double> genuine, std::vector<double> impostor);

/// identity.csv in `folder`, columns named as the fields.
Result<std::filesystem::path> write_identity_table(const std::filesystem::path& folder,
                                                   const std::vector<IdentityRow>& rows);
/// identity.png and .svg in `folder`: the share of pairs within a distance, of one person's and of different people's,
/// as they are and made harder.
Result<std::filesystem::path> plot_identity(const std::filesystem::path& folder,
                                            const std::vector<DescribedPortrait>& portraits);

} // namespace tp
