// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/figures/report/csv_table.hpp"
#include "core/statistics/pairwise.hpp"
#include "core/statistics/repeated_anova.hpp"
#include "core/study_folder/study_folder.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tp {

/// One thing that was measured, over participants and conditions.
struct StudyMeasure {
    std::string name; ///< a column: "error_mm", "time_s", "right"
    std::string axis; ///< with its unit, for people: "tracking error, mm"
    WithinMeans means;
    RepeatedAnova anova;
    std::vector<Pairwise> levels; ///< of each factor
};

/// How often which answer was given to which question.
struct Confusion {
    std::string where;              ///< the level of another factor, "radius 20 mm"; empty: over all
    std::vector<std::string> names; ///< of rows; of columns too, and then no answer
    std::vector<std::vector<std::size_t>> counts; ///< what it was × what was said
    double right() const;                         ///< a share; 0 where nothing was asked
};

struct StudyReport {
    Experiment experiment;
    std::size_t participants = 0, trials = 0, repeated = 0;
    std::vector<StudyMeasure> measures; ///< first what was done well or badly, then the time
    std::vector<Confusion>
        confusions; ///< where things were named: over all, then by each level of each other factor
    std::vector<std::string> remarks; ///< who or what is left out, and why
};

/// Faces and repetitions count as their means. An error, in one sentence, where there is nothing to say anything about.
Result<StudyReport> report_on(const StudyFolder& study);

/// A row an effect: measure, effect, sums of squares, degrees of freedom, F, p, epsilon, p after Greenhouse and Geisser, η²; empty
/// where there is none.
CsvTable effects_table(const StudyReport& report);
/// A row a level of a factor: mean, standard error, letters.
CsvTable levels_table(const StudyReport& report);
/// A row a pair of levels: difference, p.
CsvTable pairs_table(const StudyReport& report);
/// A row a question and answer: how often.
CsvTable confusion_table(const StudyReport& report);
/// Plots as PNG and SVG in `folder`; their names: "speed", time against the other measure, a dot a condition, then each measure's
/// over its factors, with standard errors.
Result<std::vector<std::string>> plot_study(const std::filesystem::path& folder, const StudyReport& report);
/// All of it as one page, beside these plots.
std::string study_page(const StudyReport& report, const std::vector<std::string>& plots);

inline constexpr const char* study_page_file = "report.html";
/// Tables, plots and page into `folder`, which is made where it is missing; an earlier report there is replaced. When this returns
/// empty all is on the disk; else it is one sentence that says what could not be written.
std::string write_report(const std::filesystem::path& folder, const StudyReport& report);

} // namespace tp
