// SPDX-License-Identifier: Apache-2.0
// Whole sittings, from consent to the last trial, with the drawn finger.
#include "study_bench.hpp"

#include <algorithm>

using namespace tp;
using State = StudyRun::State;

class StudySittingTest : public QObject {
    Q_OBJECT
private slots:
    void nothing_is_written_before_a_yes() {
        StudyBench bench;
        bench.set_up(StudyBench::lines);
        bench.session->begin();
        QCOMPARE(bench.run().state(), State::Consent);
        QVERIFY2(bench.said().contains("press Enter") && bench.said().contains("Escape"),
                 qPrintable(bench.said()));
        QVERIFY(!QDir(bench.documents()).exists());
        QVERIFY(bench.session->stop());
        QCOMPARE(bench.run().state(), State::SetUp);
        QCOMPARE(bench.said(), QString("Nothing has been kept."));
        QVERIFY(!QDir(bench.documents()).exists());
        QTRY_COMPARE_WITH_TIMEOUT(bench.session->setup()->problem(), QString(), 60000);
        bench.session->begin();
        bench.run().goOn(); // Space is no yes
        QCOMPARE(bench.run().state(), State::Consent);
        bench.run().agree();
        QTRY_COMPARE_WITH_TIMEOUT(bench.run().state(), State::Ready, 60000);
        QVERIFY(std::filesystem::exists(bench.study_folder() / study_protocol_file));
    }

    void lines_are_followed_from_the_training_to_the_last() {
        StudyBench bench;
        bench.begin(StudyBench::lines);
        QCOMPARE(bench.run().state(), State::Ready);
        QVERIFY2(bench.said().endsWith("Training 1 of 1. Follow the line. Press Space to start."),
                 qPrintable(bench.said()));
        for (int trial = 0; trial < 3; ++trial) {
            QCOMPARE(bench.run().state(), State::Ready);
            bench.follow();
            bench.settle();
            QCOMPARE(bench.records().size(), std::size_t(trial + 1));
        }
        QCOMPARE(bench.run().state(), State::Done);
        QVERIFY2(bench.said().contains("Participant 1 has done all 2 trials."), qPrintable(bench.said()));
        const auto records = bench.records();
        QVERIFY(records[0].training && !records[1].training && !records[2].training);
        QVERIFY(records[1].condition != records[2].condition);
        for (const TrialRecord& record : records) {
            QVERIFY(!record.repeated && record.error_mm && *record.error_mm < 4.0);
            QVERIFY(record.time_s > 1.0 && record.time_s < 20.0);
            const auto path = bench.path_of(record.trial);
            QVERIFY(static_cast<double>(path.size()) >= 100.0 * record.time_s);
            QVERIFY(std::abs(path.back().time_s - record.time_s) < 0.011);
            double strongest = 0.0;
            for (const FingerSample& one : path)
                strongest = std::max(strongest, std::hypot(one.fx_n, one.fy_n));
            QVERIFY2(strongest > 0.005 && strongest < 1.1, qPrintable(QString::number(strongest)));
        }
        QVERIFY(!bench.guide.sounds());
        bench.run().goOn();
        QCOMPARE(bench.run().state(), State::SetUp);
    }

    void shapes_are_named_by_a_key_with_a_break_between() {
        StudyBench bench;
        bench.begin(StudyBench::shapes);
        QVERIFY(bench.has_said("Trial 1 of 4. Feel the shape. Press Space to start."));
        for (int trial = 1; trial <= 4; ++trial) {
            QCOMPARE(bench.run().state(), State::Ready);
            const StudyTrial felt = bench.start();
            bench.go(felt.start + Vec2(20.0, 0.0));
            QCOMPARE(bench.run().state(), State::Feeling);
            QVERIFY(bench.guide.sounds()); // nobody feels a drawn finger's force
            bench.run().goOn();
            QCOMPARE(bench.run().state(), State::Answering);
            QVERIFY(!bench.guide.sounds());
            QCOMPARE(bench.said(), QString("Which was it? 1: circle. 2: square."));
            QCOMPARE(bench.run().answers(), QStringList({"circle", "square"}));
            bench.run().answer(2); // there is no third
            QCOMPARE(bench.run().state(), State::Answering);
            bench.run().answer(1);
            bench.settle();
            QCOMPARE(bench.records().size(), std::size_t(trial));
            QCOMPARE(bench.records().back().answer, std::string("square"));
            if (trial == 2) {
                QCOMPARE(bench.run().state(), State::Break);
                QVERIFY2(bench.said().contains("Participant 1 has done 2 of 4 trials."),
                         qPrintable(bench.said()));
                bench.run().goOn();
            }
        }
        QCOMPARE(bench.run().state(), State::Done);
        const auto records = bench.records();
        QCOMPARE(std::ranges::count_if(
                     records, [&](const TrialRecord& one) { return is_right(bench.experiment, one); }),
                 2);
    }

    void when_the_time_is_over_the_answer_is_asked_for() {
        StudyBench bench;
        bench.begin(StudyBench::shapes);
        bench.start();
        bench.session->advance(2.9);
        QCOMPARE(bench.run().state(), State::Feeling);
        bench.session->advance(0.2);
        QCOMPARE(bench.run().state(), State::Answering);
        QVERIFY2(bench.said().startsWith("The time is over. Which was it?"), qPrintable(bench.said()));
        bench.run().answer(0);
        bench.settle();
        QCOMPARE(bench.records().back().answer, std::string("circle"));
        QVERIFY(std::abs(bench.records().back().time_s - 3.0) < 0.02);
    }

    void an_answer_may_come_while_one_feels() {
        StudyBench bench;
        bench.begin(StudyBench::shapes);
        bench.start();
        bench.session->advance(1.0);
        bench.run().answer(0);
        bench.settle();
        QCOMPARE(bench.records().size(), std::size_t(1));
        QVERIFY(std::abs(bench.records().back().time_s - 1.0) < 0.02);
    }

    void a_knot_that_was_missed_is_said_and_the_trial_is_done_again() {
        StudyBench bench;
        bench.begin(StudyBench::lines);
        while (bench.run().state() == State::Ready && bench.now().path.closed) {
            bench.follow();
            bench.settle();
        }
        const StudyTrial curve = bench.start();
        const std::size_t before = bench.records().size();
        bench.go(curve.start + Vec2(0.0, 60.0)); // far round the middle of the curve
        bench.go(curve.path.points.back() + Vec2(0.0, 60.0));
        bench.go(curve.path.points.back());
        for (int i = 0; i < 400 && bench.run().state() == State::Feeling; ++i)
            bench.session->advance(0.005);
        bench.settle();
        QVERIFY2(bench.said().startsWith("A part of the line was left out; the trial is done again."),
                 qPrintable(bench.said()));
        QVERIFY(bench.said().contains(", once more"));
        QCOMPARE(bench.records().size(), before + 1);
        QVERIFY(bench.records().back().repeated);
        QCOMPARE(bench.run().state(), State::Ready);
        QVERIFY(bench.now().path.points.front() == curve.path.points.front() || !bench.now().path.closed);
    }

    void space_before_the_end_of_the_line_means_once_more() {
        StudyBench bench;
        bench.begin(StudyBench::lines);
        bench.follow(0.3);
        bench.run().goOn();
        bench.settle();
        QVERIFY2(bench.said().startsWith("The end of the line was not reached"), qPrintable(bench.said()));
        QVERIFY(bench.records().back().repeated && bench.records().back().training);
    }

    void an_experiment_goes_on_another_day() {
        StudyBench bench;
        bench.begin(StudyBench::shapes);
        for (int trial = 0; trial < 2; ++trial) {
            bench.start();
            bench.run().answer(0);
            bench.settle();
        }
        QVERIFY(bench.session->stop());
        QVERIFY(bench.session->stop());
        QCOMPARE(bench.run().state(), State::SetUp);
        QVERIFY2(bench.said().contains("Everything is kept. Participant 1 has done 2 of 4 trials."),
                 qPrintable(bench.said()));
        QTRY_VERIFY_WITH_TIMEOUT(
            bench.session->setup()->progress() == "Participant 1 has done 2 of 4 trials.", 60000);
        bench.session->begin();
        bench.run().agree();
        QTRY_VERIFY_WITH_TIMEOUT(bench.run().state() != State::Opening, 60000);
        QCOMPARE(bench.run().state(), State::Break);
        bench.run().goOn();
        QCOMPARE(bench.run().trial(), QString("Trial 3 of 4"));
        bench.start();
        bench.run().answer(0);
        bench.settle();
        QCOMPARE(bench.records().size(), std::size_t(3));
    }

    void what_is_tried_out_is_shown_and_not_kept() {
        StudyBench bench;
        bench.set_up(StudyBench::shapes);
        bench.session->setup()->setShowScene(true);
        bench.session->begin();
        bench.run().agree();
        QCOMPARE(bench.run().state(), State::Ready);
        QVERIFY(bench.run().shown() != nullptr);
        bench.run().goOn();
        bench.session->advance(0.1);
        bench.run().answer(0);
        QCOMPARE(bench.run().state(), State::Ready);
        bench.session->stop();
        bench.session->stop();
        QVERIFY(!QDir(bench.documents()).exists());
        QVERIFY(!bench.session->setup()->show_scene()); // never remembered
        QTRY_COMPARE_WITH_TIMEOUT(bench.session->setup()->problem(), QString(), 60000);
        bench.session->begin();
        bench.run().agree();
        QTRY_COMPARE_WITH_TIMEOUT(bench.run().state(), State::Ready, 60000);
        QVERIFY(bench.run().shown() == nullptr);
    }
};

QTEST_MAIN(StudySittingTest)
#include "study_sitting_test.moc"
