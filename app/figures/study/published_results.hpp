// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/figures/report/csv_table.hpp"
#include "app/figures/study/study_report.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// What people did in the published experiments (Lim, Yoo, Choi 2019): a number, or an order of levels.
struct PublishedResult {
    enum class Kind {
        f,        ///< an F of the analysis of variance
        mean,     ///< a mean, or from where to where it lies
        falls,    ///< the measure of the last level is below that of the first
        smallest, ///< the level has the smallest measure of its factor's
        saturates ///< the last two levels do not differ
    };
    Kind kind = Kind::f;
    std::string_view experiment; ///< its name
    std::string_view measure;    ///< "error_mm", "time_s", "right"
    std::string_view what;       ///< an effect, a factor, levels "hexagon, 20 mm"; empty: over all
    double low = 0.0, high = 0.0;
    bool significant = true; ///< of an F: p < 0.05
};
std::span<const PublishedResult> published_results();

/// One published result and what studies of the same experiment with other people gave.
struct ComparedResult {
    PublishedResult published;
    std::vector<double>
        ours; ///< of each study that says anything about it: an F, a mean; of an order 1 where it is so, else 0
    double mean = 0.0, least = 0.0, most = 0.0; ///< over the studies
    /// Whether they are alike. An F: on the same side of p = 0.05 (Greenhouse and Geisser) in most studies. An order: in most studies.
    /// A time: within a factor of two. A share: within ten points.
    bool alike = false;
};
/// What was published of the experiment of these studies, which is the same in all; nothing where nothing was.
std::vector<ComparedResult> compared_results(std::span<const StudyReport> studies);

/// "F(4, 36) = 27.65", "97.5 %", "20 to 30 s", "falls"
std::string published_words(const PublishedResult& result);
/// "stiffness × range", "hexagon, 20 mm"; with what was measured.
std::string subject_words(const PublishedResult& result);
/// "41.2 (30.5 to 55.0)": mean, smallest and largest over the studies; of an order in how many of them it is so.
std::string our_words(const ComparedResult& result);

/// A row a published result: kind, measure, what, published_low, published_high, significant, mean, least, most, studies, alike.
CsvTable published_table(std::span<const ComparedResult> results);
/// The plot "published" as PNG and SVG in `folder`: each F and mean beside ours. False: nothing was published that could be drawn.
Result<bool> plot_published(const std::filesystem::path& folder, const std::vector<ComparedResult>& results);
/// A page on what was published of an experiment beside these studies of it, with its table and plot, into `folder`, which is made where
/// it is missing: "published.html", "published.csv". When this returns empty all is on the disk; else it is one sentence.
std::string write_comparison(const std::filesystem::path& folder, std::span<const StudyReport> studies);
/// The page itself; and its rows.
std::string comparison_page(std::span<const StudyReport> studies, std::span<const ComparedResult> results);
std::string published_rows(std::span<const ComparedResult> results);

} // namespace tp
