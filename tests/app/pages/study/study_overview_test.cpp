// SPDX-License-Identifier: Apache-2.0
// What the researcher hears of a study between two sittings, and its report.
#include "study_bench.hpp"
#include "test_program.hpp"

#include <QFileInfo>

#include <fstream>

namespace study_overview_test {

using namespace tp;
using State = StudyRun::State;

namespace {

/// A participant names one of two shapes, breaks the next trial off and stops.
void sit(StudyBench& bench) {
    bench.begin(StudyBench::shapes);
    bench.start();
    bench.session->advance(1.0);
    bench.run().answer(0);
    bench.settle();
    bench.start();
    bench.session->advance(0.5);
    bench.run().pause();
    bench.settle();
    bench.session->stop();
    bench.session->stop();
    QCOMPARE(bench.run().state(), State::SetUp);
}

} // namespace

class StudyOverviewTest : public QObject {
    Q_OBJECT
private slots:
    void a_study_that_has_not_begun_is_said_to() {
        StudyBench bench;
        bench.set_up(StudyBench::shapes);
        bench.session->overview()->look();
        QCOMPARE(bench.said(), QString("The study is being checked."));
        QTRY_COMPARE_WITH_TIMEOUT(bench.said(), QString("No study has begun in this folder."), 60000);
        bench.session->overview()->makeReport();
        QTRY_COMPARE_WITH_TIMEOUT(bench.said(), QString("No study has begun in this folder."), 60000);
        QVERIFY(!QDir(bench.documents()).exists());
    }

    void how_it_stands_is_told_and_shown() {
        StudyBench bench;
        sit(bench);
        StudyOverview& overview = *bench.session->overview();
        QVERIFY(overview.lines().isEmpty());
        overview.look();
        QTRY_COMPARE_WITH_TIMEOUT(overview.lines().size(), 3, 60000);
        const bool right = is_right(bench.experiment, bench.records().front());
        const QString time = QString::number(bench.records().front().time_s, 'f', 1);
        QCOMPARE(overview.lines()[0],
                 QString("Participants: 1. Trials that count: 1. Trials done again: 1. Named rightly: %1 "
                         "percent. Mean time: %2 seconds.")
                     .arg(right ? 100 : 0)
                     .arg(time));
        QCOMPARE(overview.lines()[1], QString("Nothing is wrong in the folder."));
        QCOMPARE(overview.lines()[2],
                 QString("Participant 1: 1 trials of 4, 1 of them done again; 3 are missing."));
        QCOMPARE(bench.said(), overview.lines().join(' '));
    }

    void what_is_wrong_in_the_folder_is_told() {
        StudyBench bench;
        sit(bench);
        std::filesystem::remove(bench.study_folder() / study_paths_folder / path_file_name(1, 1));
        bench.session->overview()->look();
        QTRY_COMPARE_WITH_TIMEOUT(bench.session->overview()->lines().size(), 4, 60000);
        QCOMPARE(bench.session->overview()->lines()[1], QString("Faults in the folder: 1."));
        QCOMPARE(bench.session->overview()->lines()[2],
                 QString("Participant 1: the finger's path is missing in these trials: 1."));
    }

    void of_much_the_beginning_is_told_and_all_is_shown() {
        StudyBench bench;
        sit(bench);
        for (int trial = 1; trial <= 9; ++trial)
            std::ofstream(bench.study_folder() / study_paths_folder / path_file_name(77, trial));
        StudyOverview& overview = *bench.session->overview();
        overview.look();
        QTRY_VERIFY_WITH_TIMEOUT(overview.lines().size() > 9, 60000);
        QCOMPARE(bench.said(), overview.lines().mid(0, 5).join(' ') + " The rest is on the page.");
    }

    void the_report_lies_beside_the_study_and_its_place_is_told() {
        StudyBench bench;
        sit(bench);
        bench.session->overview()->makeReport();
        QTRY_COMPARE_WITH_TIMEOUT(bench.session->overview()->lines().size(), 1, 60000);
        const QString folder = bench.documents() + "/shapes report";
        QCOMPARE(bench.said(), QString("The report is in %1. Open the file report.html there.").arg(folder));
        QCOMPARE(bench.session->overview()->lines().back(), bench.said());
        for (const char* name : {"report.html", "effects.csv", "levels.csv", "pairs.csv", "confusion.csv"})
            QVERIFY2(QFileInfo(folder + '/' + name).size() > 0, name);
    }

    void a_report_that_cannot_be_written_is_said() {
        StudyBench bench;
        sit(bench);
        QFile in_its_place(bench.documents() + "/shapes report");
        QVERIFY(in_its_place.open(QIODevice::WriteOnly));
        bench.session->overview()->makeReport();
        QTRY_COMPARE_WITH_TIMEOUT(
            bench.said(),
            QString("The folder \"%1/shapes report\" cannot be made: there is a file of "
                    "that name already.")
                .arg(bench.documents()),
            60000);
        QVERIFY(bench.session->overview()->lines().isEmpty());
    }

    void a_report_without_a_trial_that_counts_is_refused() {
        StudyBench bench;
        bench.begin(StudyBench::shapes);
        bench.session->stop();
        bench.session->stop();
        bench.session->overview()->makeReport();
        QTRY_COMPARE_WITH_TIMEOUT(bench.said(),
                                  QString("No trial counts yet, so that there is nothing to report."), 60000);
    }

    void a_participant_meets_nothing_of_it() {
        StudyBench bench;
        sit(bench);
        StudyOverview& overview = *bench.session->overview();
        overview.look();
        QTRY_COMPARE_WITH_TIMEOUT(overview.lines().size(), 3, 60000);
        overview.look(); // is not answered before the sitting begins
        bench.session->begin();
        QCOMPARE(bench.run().state(), State::Consent);
        QVERIFY(overview.lines().isEmpty());
        bench.run().agree();
        QTRY_COMPARE_WITH_TIMEOUT(bench.run().state(), State::Ready, 60000);
        QVERIFY(overview.lines().isEmpty());
        QVERIFY2(!bench.said().contains("Participants: "), qPrintable(bench.said()));
    }

    void it_is_hidden_with_another_study_and_another_page() {
        StudyBench bench;
        sit(bench);
        StudyOverview& overview = *bench.session->overview();
        overview.look();
        QTRY_COMPARE_WITH_TIMEOUT(overview.lines().size(), 3, 60000);
        bench.session->setup()->setParticipant(3);
        QCOMPARE(overview.lines().size(), 3);
        bench.session->setup()->choose(0);
        QVERIFY(overview.lines().isEmpty());
        bench.session->setup()->choose(5);
        overview.look();
        QTRY_COMPARE_WITH_TIMEOUT(overview.lines().size(), 3, 60000);
        bench.session->leave();
        QVERIFY(overview.lines().isEmpty());
    }
};

} // namespace study_overview_test

TP_TEST(study_overview_test, StudyOverviewTest, window)
#include "study_overview_test.moc"
