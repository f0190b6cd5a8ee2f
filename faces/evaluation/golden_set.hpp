// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/evaluation/accuracy.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tp {

/// What one choice of nets reached on the people held out of all training, percent as contour_error_percent.
struct GoldenRow {
    struct Figures {
        double mean = 0.0, worst = 0.0; ///< over those in whom one face was found
    };
    std::size_t people = 0, failures = 0;          ///< see PortraitErrors::failed
    std::array<Figures, feature_count> features{}; ///< of felt_features
};

/// By the names of golden_choices.
using GoldenSet = std::map<std::string, GoldenRow>;

/// The choices that the golden set holds: our nets, ours where YuNet finds the face, the face mesh with our
/// edges.
std::map<std::string, ExtractorChoice> golden_choices();

GoldenRow golden_row(const std::vector<PortraitErrors>& measured);

/// The better of both in each figure. Of rows of other people, `measured` as it is.
GoldenRow better_of(const GoldenRow& kept, const GoldenRow& measured);

/// What differs from the golden row by more than the margin of its figure, a sentence each: worse, or better
/// and to be kept. Extraction is deterministic, so only another processor's rounding has to fit into the
/// margins; means move by less than theirs even where another detector finds the faces. Empty: nothing does.
std::vector<std::string> differences(const std::string& row, const GoldenRow& golden,
                                     const std::vector<PortraitErrors>& measured);

/// The largest figures that are no difference: 2 % + 0.005 for a mean; for a worst contour, which one person
/// decides, 5 % + 0.02.
double most_allowed_mean(double golden);
double most_allowed_worst(double golden);

/// A line for each row and figure; read_golden_set reads it back, to the fourth decimal.
std::string text_of(const GoldenSet& set);
/// An error where the file cannot be read or is not such a text.
Result<GoldenSet> read_golden_set(const std::filesystem::path& file);

} // namespace tp
