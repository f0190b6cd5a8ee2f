// SPDX-License-Identifier: Apache-2.0
#include "app/figures/study/study_report.hpp"
#include "drawn_study.hpp"

#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <cmath>
#include <random>

using namespace tp;
using namespace tp::testing;
namespace fs = std::filesystem;

namespace {

const std::string following =
    "experiment: follow-it\ntitle: Following <contours>\ntask: follow\nfactor stiffness: 0.1, 0.3, 0.5 N/mm\n"
    "factor path: circle, curve\nrepetitions: 2\ntraining: 2\n";
const std::string naming =
    "experiment: name-it\ntask: name\nfactor expression: smiling, sad, angry\nfactor face: 1, 2, 3, 4\n"
    "factor law: exact, published\nanswer: expression\n";

/// The error falls with stiffness and is no matter of the path; the time hangs on the path alone.
void follow(const Experiment& experiment, int participant, const PlannedTrial& trial, TrialRecord& record) {
    std::mt19937 random(static_cast<unsigned>(trial.seed));
    std::normal_distribution<double> noise(0.0, 0.1);
    const auto levels = experiment.levels_of(trial.condition);
    record.error_mm = 3.0 - 0.8 * static_cast<double>(levels[0]) + 0.05 * participant + noise(random);
    record.time_s = 10.0 + 4.0 * static_cast<double>(levels[1]) + 0.2 * participant + noise(random);
    if (trial.training) { // as clumsy as a beginner
        record.error_mm = 100.0;
        record.time_s = 1000.0;
    }
}

StudyFolder followed(const fs::path& folder, int participants) {
    const Experiment experiment = read_experiment(following).value();
    draw_study(folder, following, participants,
               [&](int participant, const PlannedTrial& trial, TrialRecord& record) {
                   follow(experiment, participant, trial, record);
               });
    return read_study(folder).value();
}

/// Smiling is always named, angry is called sad by the published law, and one sad face is not named at all.
StudyFolder named(const fs::path& folder) {
    const Experiment experiment = read_experiment(naming).value();
    draw_study(folder, naming, 4, [&](int participant, const PlannedTrial& trial, TrialRecord& record) {
        const std::string was = experiment.value_of(StudyParameter::expression, trial.condition);
        const bool published = experiment.value_of(StudyParameter::law, trial.condition) == "published";
        const std::string face = experiment.value_of(StudyParameter::face, trial.condition);
        record.answer = was == "angry" && published                       ? "sad"
                        : was == "sad" && face == "2" && participant == 1 ? ""
                                                                          : was;
        record.time_s = 20.0 + participant;
    });
    return read_study(folder).value();
}

const WithinEffect& effect(const StudyMeasure& measure, const std::string& words) {
    for (const WithinEffect& one : measure.anova.effects)
        if (words_for(one, measure.means.factors) == words)
            return one;
    qFatal("no effect %s", words.c_str());
}

} // namespace

class StudyReportTest : public QObject {
    Q_OBJECT
    QTemporaryDir dir_;
    fs::path folder(const char* name) const { return fs::path(dir_.path().toStdString()) / name; }

private slots:
    void a_difference_that_is_there_is_found_and_training_does_not_count() {
        const auto report = report_on(followed(folder("a"), 8));
        QVERIFY2(report.ok(), report.error().c_str());
        QCOMPARE(report->participants, std::size_t{8});
        QCOMPARE(report->trials, std::size_t{8 * 12});
        QCOMPARE(report->measures.size(), std::size_t{2});
        const StudyMeasure& error = report->measures[0];
        QCOMPARE(error.axis, std::string("tracking error, mm"));
        QVERIFY(*effect(error, "stiffness").p_spherical < 1e-4);
        QVERIFY(*effect(error, "path").p > 0.01);
        QVERIFY(std::abs(error.levels[0].levels[0].mean - 3.225) < 0.1); // 3 and the mean of 0.05 × 1 … 8
        QCOMPARE(error.levels[0].levels[0].letters + error.levels[0].levels[1].letters +
                     error.levels[0].levels[2].letters,
                 std::string("cba"));
        const StudyMeasure& time = report->measures[1];
        QVERIFY(*effect(time, "path").p < 1e-6 && *effect(time, "stiffness").p > 0.01);
        QVERIFY(report->remarks.empty());
        QVERIFY(report->confusions.empty());
    }
    void that_participants_are_simulated_is_told() {
        StudyFolder study = followed(folder("simulated"), 3);
        for (const bool simulated : {true, false}) {
            study.terms = StudyTerms{1, simulated};
            QCOMPARE(report_on(study)->remarks.size(), std::size_t(simulated ? 1 : 0));
        }
    }
    void what_was_done_again_does_not_count() {
        StudyFolder study = followed(folder("b"), 3);
        TrialRecord again = study.records.back();
        again.repeated = true;
        again.error_mm = 1e5;
        study.records.push_back(again);
        const auto report = report_on(study);
        QCOMPARE(report->repeated, std::size_t{1});
        for (const LevelMean& level : report->measures[0].levels[0].levels)
            QVERIFY(level.mean < 4.0);
    }
    void who_has_not_done_everything_is_left_out_by_name_and_told_once() {
        StudyFolder study = followed(folder("c"), 4);
        std::erase_if(study.records, [](const TrialRecord& record) {
            return record.participant == 2 && record.condition == 3;
        });
        const auto report = report_on(study);
        QCOMPARE(report->remarks,
                 std::vector<std::string>{
                     "Participant 002 is left out: there is no trial with stiffness 0.3 N/mm, "
                     "path curve."});
        QCOMPARE(report->measures[0].means.participants, (std::vector<std::string>{"001", "003", "004"}));
    }
    void one_participant_has_means_and_a_sentence() {
        const auto report = report_on(followed(folder("d"), 1));
        QVERIFY2(report.ok(), report.error().c_str());
        QCOMPARE(report->remarks,
                 std::vector<std::string>{"With one participant nothing can be said about others."});
        QVERIFY(plot_study(folder("d"), *report).ok());
        QVERIFY(study_page(*report, {}).find("nan") == std::string::npos);
    }
    void a_study_without_a_trial_says_so() {
        StudyFolder study = followed(folder("e"), 1);
        std::erase_if(study.records, [](const TrialRecord& record) { return !record.training; });
        QCOMPARE(report_on(study).error(), std::string("There are no trials yet that count."));
    }
    void what_was_called_what_is_counted_by_hand() {
        const auto report = report_on(named(folder("f")));
        QVERIFY2(report.ok(), report.error().c_str());
        QCOMPARE(report->confusions.size(), std::size_t{3}); // all, exact, published; not by face
        const Confusion& all = report->confusions[0];
        QCOMPARE(all.counts[0], (std::vector<std::size_t>{32, 0, 0, 0}));
        QCOMPARE(all.counts[1], (std::vector<std::size_t>{0, 30, 0, 2})); // one face, by either law
        QCOMPARE(all.counts[2], (std::vector<std::size_t>{0, 16, 16, 0}));
        QCOMPARE(all.right(), 78.0 / 96.0);
        QCOMPARE(report->confusions[2].where, std::string("law published"));
        QCOMPARE(report->confusions[2].counts[2], (std::vector<std::size_t>{0, 16, 0, 0}));
        QVERIFY(report->measures[0].means.factors.size() == 2); // faces are people at large
        QVERIFY(report->measures[0].levels[1].levels[0].mean > report->measures[0].levels[1].levels[1].mean);
    }
    void tables_plots_and_page_say_the_same() {
        const auto report = report_on(followed(folder("g"), 6));
        QCOMPARE(effects_table(*report).row_count(), std::size_t{2 * 3});
        QCOMPARE(levels_table(*report).row_count(), std::size_t{2 * 5});
        QCOMPARE(pairs_table(*report).row_count(), std::size_t{2 * 4});
        const auto plots = plot_study(folder("g"), *report);
        QVERIFY2(plots.ok(), plots.error().c_str());
        QCOMPARE(*plots, (std::vector<std::string>{"speed", "error_mm", "time_s"}));
        const std::string page = study_page(*report, *plots);
        for (const std::string& name : *plots) {
            QVERIFY(!QImage(QString::fromStdString((folder("g") / (name + ".png")).string())).isNull());
            QVERIFY(page.find("<img src=\"" + name + ".svg\" alt=\"") != std::string::npos);
        }
        QVERIFY(page.find("Following &lt;contours&gt;") != std::string::npos);
        QVERIFY(page.find("<td>stiffness × path</td>") != std::string::npos);
        QVERIFY(page.find("96 trials") == std::string::npos &&
                page.find("72 trials that count") != std::string::npos);
    }
    void the_page_is_well_formed_and_has_no_number_that_is_none() {
        for (const auto& report : {report_on(followed(folder("h"), 5)), report_on(named(folder("i")))}) {
            QString page = QString::fromStdString(study_page(*report, {"speed", "right"}));
            QVERIFY(!page.contains("nan") && !page.contains("inf"));
            page.remove("<!DOCTYPE html>").replace("<meta charset=\"utf-8\">", "<meta charset=\"utf-8\"/>");
            page.replace(QRegularExpression("(<img [^>]*)>"), "\\1/>");
            QXmlStreamReader reader(page);
            while (!reader.atEnd())
                reader.readNext();
            QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
        }
    }

    void all_of_it_is_written_into_a_folder_and_an_earlier_report_is_replaced() {
        QTemporaryDir dir;
        const fs::path study = fs::path(dir.path().toStdString()) / "study",
                       out = fs::path(dir.path().toStdString()) / "new" / "report";
        const StudyReport report = report_on(named(study)).value();
        QCOMPARE(write_report(out, report), std::string());
        write_file(out / study_page_file, "of yesterday");
        QCOMPARE(write_report(out, report), std::string());
        for (const char* name : {"report.html", "effects.csv", "levels.csv", "pairs.csv", "confusion.csv",
                                 "speed.png", "speed.svg", "right.svg", "time_s.svg"})
            QVERIFY2(fs::exists(out / name) && fs::file_size(out / name) > 20, name);
        QCOMPARE(write_report(study / "protocol.study", report),
                 "The folder \"" + (study / "protocol.study").string() +
                     "\" cannot be made: there is a file of that name already.");
    }
};

QTEST_MAIN(StudyReportTest)
#include "study_report_test.moc"
