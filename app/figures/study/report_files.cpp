// SPDX-License-Identifier: Apache-2.0
#include "app/figures/study/published_results.hpp"
#include "app/figures/study/study_report.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <span>

namespace tp {

std::string write_report(const std::filesystem::path& folder, const StudyReport& report) {
    if (const std::string reason = make_folder(folder); !reason.empty())
        return "The folder " + quoted(folder) + " cannot be made: " + reason;
    std::vector<Result<std::filesystem::path>> tables{effects_table(report).write(folder / "effects.csv"),
                                                      levels_table(report).write(folder / "levels.csv"),
                                                      pairs_table(report).write(folder / "pairs.csv")};
    if (!report.confusions.empty())
        tables.push_back(confusion_table(report).write(folder / "confusion.csv"));
    for (const auto& written : tables)
        if (!written)
            return written.error();
    auto plots = plot_study(folder, report);
    if (!plots)
        return plots.error();
    if (const auto compared = compared_results(std::span(&report, 1)); !compared.empty()) {
        if (const auto written = published_table(compared).write(folder / "published.csv"); !written)
            return written.error();
        const auto drawn = plot_published(folder, compared);
        if (!drawn)
            return drawn.error();
        if (*drawn)
            plots->push_back("published");
    }
    const std::filesystem::path page = folder / study_page_file;
    const std::string reason = replace_file(page, study_page(report, *plots));
    return reason.empty() ? std::string() : "The page " + quoted(page) + " cannot be written: " + reason;
}

} // namespace tp
