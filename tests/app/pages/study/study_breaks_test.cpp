// SPDX-License-Identifier: Apache-2.0
// What interrupts a sitting: a pause, another window, another page, Escape, a disk that does not take it.
#include "core/study_folder/running_trial.hpp"
#include "study_bench.hpp"

using namespace tp;
using State = StudyRun::State;

class StudyBreaksTest : public QObject {
    Q_OBJECT

    static bool forceless(StudyBench& bench) {
        return !bench.session->finger().has_servo() || bench.session->finger().seen().force() == Vec2(0.0);
    }
    /// In a trial, with the force on the finger.
    static void feel(StudyBench& bench) {
        bench.begin(StudyBench::lines);
        bench.follow(0.3);
        QCOMPARE(bench.run().state(), State::Feeling);
    }

private slots:
    void a_pause_takes_the_force_at_once_and_the_trial_is_done_again() {
        StudyBench bench;
        feel(bench);
        const StudyTrial before = bench.now();
        bench.run().pause();
        QVERIFY(forceless(bench));
        QVERIFY(!bench.guide.sounds());
        bench.settle();
        QCOMPARE(bench.run().state(), State::Paused);
        QCOMPARE(bench.said(), QString("Paused. The trial is done again. Press Space to go on."));
        QCOMPARE(bench.records().size(), std::size_t(1));
        QVERIFY(bench.records()[0].repeated);
        bench.session->advance(1.0);
        QVERIFY(forceless(bench));
        bench.run().goOn();
        QCOMPARE(bench.run().state(), State::Ready);
        QVERIFY2(bench.said().contains("Training 1 of 1, once more."), qPrintable(bench.said()));
        QCOMPARE(bench.now().path.closed, before.path.closed);
    }

    void the_force_goes_with_the_window_s_focus() {
        StudyBench bench;
        feel(bench);
        bench.session->setActive(false);
        QVERIFY(forceless(bench));
        bench.settle();
        QCOMPARE(bench.run().state(), State::Paused);
        bench.voice.clear();
        bench.session->setActive(true);
        QVERIFY2(bench.said().contains("Paused. Press Space to go on."), qPrintable(bench.said()));
        QCOMPARE(bench.run().state(), State::Paused);
    }

    void the_page_is_left_and_come_back_to() {
        StudyBench bench;
        feel(bench);
        bench.session->leave();
        QVERIFY(!bench.session->finger().has_servo());
        bench.settle();
        QCOMPARE(bench.run().state(), State::Paused);
        bench.session->enter();
        QVERIFY2(bench.said().contains("Paused. Press Space to go on."), qPrintable(bench.said()));
        bench.run().goOn();
        QCOMPARE(bench.run().state(), State::Ready);
        bench.follow();
        bench.settle();
        QCOMPARE(bench.records().size(), std::size_t(2));
        QVERIFY(bench.records()[0].repeated && !bench.records()[1].repeated);
    }

    void escape_asks_once_and_then_goes() {
        StudyBench bench;
        feel(bench);
        QVERIFY(bench.session->stop());
        QVERIFY(forceless(bench));
        bench.settle();
        QCOMPARE(bench.run().state(), State::Stopping);
        QVERIFY2(bench.said().startsWith("Stop the study? The force is off."), qPrintable(bench.said()));
        bench.run().goOn();
        QCOMPARE(bench.run().state(), State::Ready);
        QVERIFY(bench.session->stop());
        QCOMPARE(bench.run().state(), State::Stopping);
        QVERIFY(bench.session->stop());
        QCOMPARE(bench.run().state(), State::SetUp);
        QCOMPARE(bench.records().size(), std::size_t(1));
        QVERIFY(!bench.session->stop()); // the shell leads home
    }

    void a_trial_that_cannot_be_written_is_said_and_does_not_count() {
        StudyBench bench;
        bench.begin(StudyBench::lines);
        const QString paths = QString::fromStdString((bench.study_folder() / study_paths_folder).string());
        QVERIFY(QDir(paths).removeRecursively());
        QFile in_the_way(paths); // no folder can be made there
        QVERIFY(in_the_way.open(QIODevice::WriteOnly));
        in_the_way.close();
        bench.follow();
        bench.settle();
        QCOMPARE(bench.run().state(), State::Paused);
        QVERIFY2(bench.said().contains("could not be kept and does not count. Press Space to do it again."),
                 qPrintable(bench.said()));
        QCOMPARE(bench.records().size(), std::size_t(0));
        QVERIFY(forceless(bench));
        QVERIFY(in_the_way.remove());
        QVERIFY(QDir().mkpath(paths));
        bench.run().goOn();
        QCOMPARE(bench.run().trial(), QString("Training 1 of 1"));
        bench.follow();
        bench.settle();
        QCOMPARE(bench.records().size(), std::size_t(1));
        QCOMPARE(bench.run().state(), State::Ready);
    }

    void somebody_who_goes_away_is_not_waited_for_with_the_force_on() {
        StudyBench bench;
        bench.begin("experiment: long\ntask: name\nfactor shape: circle, square\nanswer: shape\n");
        bench.start();
        bench.session->advance(FeltTrial::longest_s + 1.0);
        bench.settle();
        QCOMPARE(bench.run().state(), State::Paused);
        QVERIFY2(bench.said().startsWith("This trial has gone on for half an hour."),
                 qPrintable(bench.said()));
        QVERIFY(forceless(bench));
    }

    void a_pause_before_the_finger_was_seen_is_kept_like_any_other() {
        StudyBench bench;
        bench.begin(StudyBench::lines);
        bench.run().goOn();
        bench.run().pause();
        bench.settle();
        QCOMPARE(bench.run().state(), State::Paused);
        QCOMPARE(bench.records().size(), std::size_t(1));
        QVERIFY(bench.records()[0].repeated && !bench.records()[0].error_mm);
        bench.run().goOn();
        QCOMPARE(bench.run().state(), State::Ready);
    }

    void a_pause_between_trials_loses_nothing() {
        StudyBench bench;
        bench.begin(StudyBench::lines);
        bench.run().pause();
        QCOMPARE(bench.run().state(), State::Paused);
        QCOMPARE(bench.records().size(), std::size_t(0));
        bench.run().pause(); // again: nothing
        bench.run().goOn();
        QCOMPARE(bench.run().state(), State::Ready);
    }

    void a_trial_that_a_kill_took_is_told_the_next_time() {
        const QString lost = "A trial was running when the program ended; it is done again.";
        StudyBench bench;
        bench.begin(StudyBench::shapes);
        bench.start();
        QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(bench.study_folder() / study_running_file), 60000);
        bench.session->advance(0.5);
        bench.run().answer(0);
        bench.settle();
        QVERIFY(!std::filesystem::exists(bench.study_folder() / study_running_file));
        bench.session->stop();
        bench.session->stop();
        QCOMPARE(note_running(bench.study_folder(), 1, 2), std::string()); // as if it had been killed
        bench.session->setup()->setParticipant(1);
        QTRY_COMPARE_WITH_TIMEOUT(bench.session->setup()->progress(),
                                  "Participant 1 has done 1 of 4 trials. " + lost, 60000);
        bench.session->begin();
        bench.run().agree();
        QTRY_COMPARE_WITH_TIMEOUT(bench.run().state(), State::Ready, 60000);
        QVERIFY2(bench.said().startsWith(lost), qPrintable(bench.said()));
        QCOMPARE(bench.run().trial(), QString("Trial 2 of 4"));
    }
};

QTEST_MAIN(StudyBreaksTest)
#include "study_breaks_test.moc"
