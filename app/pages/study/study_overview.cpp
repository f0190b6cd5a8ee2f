// SPDX-License-Identifier: Apache-2.0
#include "app/pages/study/study_overview.hpp"

#include "app/figures/study/study_report.hpp"
#include "app/pages/study/study_words.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_name.hpp"
#include "core/study_folder/study_check.hpp"
#include "core/study_folder/study_summary.hpp"

#include <utility>

namespace tp {

namespace {

constexpr int most_told = 5; ///< lines, the most important first: of thirty participants one reads

bool is_begun(const std::filesystem::path& folder) { return name_taken(folder / study_protocol_file); }

} // namespace

StudyOverview::StudyOverview(const StudySetup& setup, StudyTeller& teller) : setup_(setup), teller_(teller) {
    connect(&setup_, &StudySetup::changed, this, [this] {
        if (!folder_.empty() && setup_.study_folder() != folder_)
            hide();
    });
}

std::filesystem::path StudyOverview::report_folder(const std::filesystem::path& study) {
    const std::filesystem::path whole = study.has_filename() ? study : study.parent_path(); // "study/"
    return whole.parent_path() / (whole.filename().u16string() + u" report");
}

void StudyOverview::show(QStringList lines) {
    lines_ = std::move(lines);
    emit changed();
}

void StudyOverview::hide() {
    reading_.cancel();
    folder_.clear();
    show({});
}

void StudyOverview::look() {
    folder_ = setup_.study_folder();
    teller_.tell(tr("The study is being checked."));
    reading_.ask([this, folder = folder_](const std::stop_token& stop) -> LatestTask::Answer {
        QStringList lines;
        if (!is_begun(folder)) {
            lines << tr("No study has begun in this folder.");
        } else if (const auto study = read_study(folder); !study) {
            lines << in_persons_language(study.error());
        } else {
            const StudyFindings found = check_study(folder, *study, {}, stop);
            lines << StudyWords::summary(summary_of(*study))
                  << (found.faults.empty() ? tr("Nothing is wrong in the folder.")
                                           : tr("Faults in the folder: %1.").arg(found.faults.size()));
            for (const std::string& fault : found.faults)
                lines << in_persons_language(fault);
            for (const std::string& sentence : study_progress(*study))
                lines << in_persons_language(sentence);
        }
        return [this, lines] {
            show(lines);
            QStringList told = lines.mid(0, most_told);
            if (told.size() < lines.size())
                told << tr("The rest is on the page.");
            teller_.tell(told.join(' '));
        };
    });
}

void StudyOverview::makeReport() {
    folder_ = setup_.study_folder();
    teller_.tell(tr("The report is being made."));
    reading_.ask([this, folder = folder_](const std::stop_token&) -> LatestTask::Answer {
        const std::filesystem::path there = report_folder(folder);
        QString problem;
        if (!is_begun(folder)) {
            problem = tr("No study has begun in this folder.");
        } else if (const auto study = read_study(folder); !study) {
            problem = in_persons_language(study.error());
        } else if (const auto report = report_on(*study); !report) {
            problem = tr("No trial counts yet, so that there is nothing to report.");
        } else {
            problem = in_persons_language(write_report(there, *report));
        }
        return [this, problem, there] {
            if (!problem.isEmpty())
                return teller_.problem(problem);
            const QString done = tr("The report is in %1. Open the file %2 there.")
                                     .arg(QString::fromStdString(name_in_utf8(there)), study_page_file);
            show(lines_ + QStringList{done});
            teller_.tell(done);
        };
    });
}

} // namespace tp
