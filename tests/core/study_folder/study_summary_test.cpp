// SPDX-License-Identifier: Apache-2.0
#include "core/experiment/experiment_file.hpp"
#include "core/study_folder/study_summary.hpp"

#include <QTest>

#include <string>

using namespace tp;

namespace {

TrialRecord record_of(int participant, double time_s) {
    TrialRecord record;
    record.participant = participant;
    record.time_s = time_s;
    return record;
}

} // namespace

class StudySummaryTest : public QObject {
    Q_OBJECT
private slots:
    void means_are_over_the_trials_that_count() {
        StudyFolder study;
        study.experiment =
            read_experiment("experiment: small\ntask: follow\nfactor range: 2, 4 mm\ntraining: 1\n").value();
        study.records = {record_of(1, 100.0), record_of(1, 4.0), record_of(1, 50.0), record_of(2, 8.0),
                         record_of(3, 70.0)};
        study.records[0].training = true;
        study.records[2].repeated = true;
        study.records[4].repeated = true;
        for (TrialRecord& record : study.records)
            record.error_mm = record.time_s / 4.0;
        study.records[3].error_mm.reset();
        const StudySummary summary = summary_of(study);
        QCOMPARE(summary.participants, std::size_t{3});
        QCOMPARE(summary.trials, std::size_t{2});
        QCOMPARE(summary.repeated, std::size_t{2});
        QCOMPARE(summary.time_s.value(), 6.0);
        QCOMPARE(summary.error_mm.value(), 1.0);
        QVERIFY(!summary.right);
    }
    void what_is_named_rightly_is_a_share() {
        StudyFolder study;
        study.experiment = read_experiment("experiment: shapes\ntask: name\nfactor shape: circle, square\n"
                                           "answer: shape\n")
                               .value();
        study.records = {record_of(1, 1.0), record_of(1, 1.0), record_of(1, 1.0), record_of(1, 1.0)};
        for (TrialRecord& record : study.records)
            record.answer = "square";
        study.records[1].condition = 1;
        const StudySummary summary = summary_of(study);
        QCOMPARE(summary.right.value(), 0.25);
        QVERIFY(!summary.error_mm);
    }
    void before_the_first_trial_nothing_is_a_mean() {
        StudyFolder study;
        study.experiment = read_experiment("experiment: shapes\ntask: name\nfactor shape: circle, square\n"
                                           "answer: shape\n")
                               .value();
        const StudySummary summary = summary_of(study);
        QCOMPARE(summary.participants, std::size_t{0});
        QVERIFY(!summary.time_s && !summary.error_mm && !summary.right);
    }
};

QTEST_GUILESS_MAIN(StudySummaryTest)
#include "study_summary_test.moc"
