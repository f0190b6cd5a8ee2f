// SPDX-License-Identifier: Apache-2.0
// What interrupts a sitting, by itself: a pause, Escape, a page that is left, a disk that does not take it; and that nothing is
// lost by it.
#include "core/study_folder/running_trial.hpp"
#include "study_parts.hpp"
#include "test_program.hpp"

#include <QDir>
#include <QFile>
#include <QSignalSpy>

#include <functional>

namespace study_run_breaks_test {

using namespace tp;
using State = StudyRun::State;

class StudyRunBreaksTest : public QObject {
    Q_OBJECT

    static bool forceless(StudyParts& bench) {
        return !bench.finger.has_servo() || bench.finger.seen().force() == Vec2(0.0);
    }
    /// In a trial, with the force on the finger.
    static void feel(StudyParts& bench) {
        bench.begin(StudyParts::lines);
        bench.follow(0.3);
        QCOMPARE(bench.run().state(), State::Feeling);
        QVERIFY(!forceless(bench) && bench.guide.sounds());
    }

private slots:
    void nothing_is_written_before_a_yes() {
        StudyParts bench;
        bench.run().begin(bench.plan(StudyParts::lines));
        QVERIFY2(bench.said().contains("press Enter") && bench.said().contains("Escape") &&
                     bench.said().contains("under the number 1 "),
                 qPrintable(bench.said()));
        bench.run().goOn(); // Space is no yes
        const QSignalSpy ended(bench.sitting.get(), &StudyRun::ended);
        QVERIFY(bench.run().stop());
        QCOMPARE(bench.said(), QString("Nothing has been kept."));
        QCOMPARE(ended.size(), 1);
        QVERIFY(!QDir(bench.documents()).exists());
        bench.begin(StudyParts::lines);
        QVERIFY(std::filesystem::exists(bench.study_folder() / study_protocol_file));
    }

    void a_pause_takes_the_force_at_once_and_the_trial_is_done_again() {
        StudyParts bench;
        feel(bench);
        const StudyTrial before = bench.now();
        bench.run().pause();
        QVERIFY(forceless(bench));
        QVERIFY(!bench.guide.sounds());
        bench.settle();
        QCOMPARE(bench.said(), QString("Paused. The trial is done again. Press Space to go on."));
        QCOMPARE(bench.records().size(), std::size_t(1));
        QVERIFY(bench.records()[0].repeated);
        QVERIFY(!bench.path_of(1).empty()); // what was felt so far is kept too
        bench.pass(1.0);
        QVERIFY(forceless(bench));
        bench.run().goOn();
        QCOMPARE(bench.run().state(), State::Ready);
        QVERIFY2(bench.said().contains("Training 1 of 1, once more."), qPrintable(bench.said()));
        QCOMPARE(bench.now().path.closed, before.path.closed);
        bench.follow();
        bench.settle();
        QCOMPARE(bench.records().size(), std::size_t(2));
        QVERIFY(!bench.records()[1].repeated);
    }

    void a_pause_says_why_there_is_one() {
        StudyParts bench;
        feel(bench);
        bench.run().pause_because("The lamp fell down.");
        bench.settle();
        QCOMPARE(bench.said(),
                 QString("The lamp fell down. Paused. The trial is done again. Press Space to go on."));
        bench.run().goOn();
        bench.run().pause_because("The lamp fell down.");
        QCOMPARE(bench.said(), QString("The lamp fell down. Paused. Press Space to go on."));
        QCOMPARE(bench.records().size(), std::size_t(1)); // no trial was under way
    }

    void a_pause_before_the_finger_was_seen_is_kept_like_any_other() {
        StudyParts bench;
        bench.begin(StudyParts::lines);
        bench.run().goOn();
        bench.run().pause();
        bench.settle();
        QCOMPARE(bench.run().state(), State::Paused);
        QCOMPARE(bench.records().size(), std::size_t(1));
        QVERIFY(bench.records()[0].repeated && !bench.records()[0].error_mm);
    }

    void what_interrupts_while_it_is_written_loses_no_trial_that_counts() {
        const QString paused = "Paused. Press Space to go on.";
        const QString asked =
            "Stop the study? The force is off. Press Escape again to stop, or Space to go on.";
        struct Interruption {
            std::function<void(StudyRun&)> comes;
            State then;
            QString said;
        };
        const Interruption interruptions[]{
            {[](StudyRun& run) { run.pause(); }, State::Paused, paused},
            {[](StudyRun& run) { run.stop(); }, State::Stopping, asked},
            {[](StudyRun& run) { run.leave(); }, State::Paused, paused},
            {[](StudyRun& run) { run.stop(), run.leave(); }, State::Stopping, asked}};
        for (const Interruption& interruption : interruptions) {
            StudyParts bench;
            bench.begin(StudyParts::shapes);
            bench.start();
            bench.run().answer(1);
            interruption.comes(bench.run());
            QCOMPARE(bench.run().state(), State::Keeping); // until it is on the disk
            bench.settle();
            QCOMPARE(bench.run().state(), interruption.then);
            QCOMPARE(bench.said(), interruption.said);
            QCOMPARE(bench.records().size(), std::size_t(1));
            QVERIFY(!bench.records()[0].repeated);
            QCOMPARE(bench.run().progress_words(), QString("Participant 1 has done 1 of 4 trials."));
            bench.run().goOn();
            QCOMPARE(bench.run().state(), State::Ready);
            QCOMPARE(bench.run().trial(), QString("Trial 2 of 4"));
        }
    }

    void a_program_that_ends_while_it_is_written_loses_none_either() {
        StudyParts bench;
        bench.begin(StudyParts::shapes);
        bench.start();
        bench.run().answer(1);
        bench.sitting.reset();
        bench.keeping.reset(); // which takes its time
        QCOMPARE(bench.records().size(), std::size_t(1));
        QCOMPARE(bench.records()[0].answer, std::string("square"));
    }

    void escape_asks_once_and_then_goes() {
        StudyParts bench;
        feel(bench);
        QVERIFY(bench.run().stop());
        QVERIFY(forceless(bench));
        bench.settle();
        QCOMPARE(bench.run().state(), State::Stopping);
        QVERIFY2(bench.said().startsWith("Stop the study? The force is off."), qPrintable(bench.said()));
        bench.run().goOn();
        QCOMPARE(bench.run().state(), State::Ready);
        bench.run().stop();
        const QSignalSpy ended(bench.sitting.get(), &StudyRun::ended);
        QVERIFY(bench.run().stop());
        QCOMPARE(ended.size(), 1);
        QVERIFY2(
            bench.said().startsWith("Stopped. Everything is kept. Participant 1 has done 0 of 2 trials."),
            qPrintable(bench.said()));
        QVERIFY(!bench.finger.has_servo());
        QCOMPARE(bench.records().size(), std::size_t(1));
        QVERIFY(!bench.run().stop()); // the shell leads home
        StudyParts other;
        const StudyPlan plan = bench.plan(StudyParts::lines);
        const auto may_write = [&] { // the folder is free for somebody else
            other.run().begin(plan);
            other.run().agree();
            other.opened();
            return other.run().state() == State::Ready;
        };
        QTRY_VERIFY_WITH_TIMEOUT(may_write(), 60000);
    }

    void a_trial_that_cannot_be_written_is_said_and_does_not_count() {
        for (const bool asked_to_stop : {false, true}) {
            StudyParts bench;
            bench.begin(StudyParts::lines);
            const QString paths =
                QString::fromStdString((bench.study_folder() / study_paths_folder).string());
            QVERIFY(QDir(paths).removeRecursively());
            QFile in_the_way(paths); // no folder can be made there
            QVERIFY(in_the_way.open(QIODevice::WriteOnly));
            in_the_way.close();
            bench.follow();
            if (asked_to_stop)
                bench.run().stop();
            bench.settle();
            QCOMPARE(bench.run().state(), asked_to_stop ? State::Stopping : State::Paused);
            QVERIFY2(
                bench.said().contains("could not be kept and does not count. Press Space to do it again."),
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
    }

    void a_folder_that_cannot_be_used_ends_it_with_a_sentence() {
        StudyParts bench;
        QFile in_the_way(bench.documents());
        QVERIFY(in_the_way.open(QIODevice::WriteOnly));
        bench.begin(StudyParts::lines);
        QCOMPARE(bench.run().state(), State::SetUp);
        QVERIFY2(bench.said().contains(bench.documents()), qPrintable(bench.said()));
        QVERIFY(bench.sounded(Earcon::error));
        QVERIFY(!bench.finger.has_servo());
    }

    void somebody_who_goes_away_is_not_waited_for_with_the_force_on() {
        StudyParts bench;
        bench.begin("experiment: long\ntask: name\nfactor shape: circle, square\nanswer: shape\n");
        bench.start();
        bench.pass(FeltTrial::longest_s + 1.0);
        bench.settle();
        QCOMPARE(bench.run().state(), State::Paused);
        QVERIFY2(bench.said().startsWith("This trial has gone on for half an hour."),
                 qPrintable(bench.said()));
        QVERIFY(forceless(bench) && bench.records().back().repeated);
    }

    void a_page_that_is_left_has_no_finger_and_is_come_back_to() {
        StudyParts bench;
        feel(bench);
        bench.run().leave();
        QVERIFY(!bench.finger.has_servo());
        bench.settle();
        QCOMPARE(bench.run().state(), State::Paused);
        QVERIFY(bench.records()[0].repeated);
        bench.run().goOn();
        QCOMPARE(bench.run().state(), State::Ready);
        bench.run().leave();
        QCOMPARE(bench.run().state(), State::Paused);
        QCOMPARE(bench.records().size(), std::size_t(1));
        StudyParts early;
        early.run().begin(early.plan(StudyParts::lines));
        early.run().agree();
        early.run().leave(); // before the folder was there
        QCOMPARE(early.run().state(), State::Consent);
        early.run().agree();
        early.opened();
        QCOMPARE(early.run().state(), State::Ready);
    }

    void an_answer_for_one_person_is_not_taken_for_the_next() {
        StudyParts bench;
        bench.begin(StudyParts::shapes);
        bench.name(0);
        bench.run().stop(), bench.run().stop();
        bench.run().begin(bench.plan(StudyParts::shapes));
        bench.run().agree();
        bench.run().stop(); // before the folder was there
        bench.participant = 2;
        bench.begin(StudyParts::shapes);
        QCOMPARE(bench.run().progress_words(), QString("Participant 2 has done 0 of 4 trials."));
        QVERIFY2(!bench.said().contains("Participant"), qPrintable(bench.said()));
        bench.name(0);
        QCOMPARE(bench.records().size(), std::size_t(1));
    }

    void the_next_person_has_breaks_and_trials_of_their_own() {
        StudyParts bench;
        for (const int participant : {1, 2}) {
            bench.participant = participant;
            bench.run().begin(bench.plan(StudyParts::shapes));
            QCOMPARE(bench.run().fraction(), 0.0);
            QCOMPARE(bench.run().trial(), QString());
            bench.run().agree();
            bench.opened();
            bench.name(0);
            bench.name(0);
            QCOMPARE(bench.run().state(), State::Break);
            bench.run().goOn();
            QCOMPARE(bench.run().state(), State::Ready);
            bench.run().stop(), bench.run().stop();
        }
    }

    void an_experiment_goes_on_where_it_was_left() {
        StudyParts bench;
        bench.begin(StudyParts::shapes);
        bench.name(0);
        bench.name(0);
        bench.run().stop(), bench.run().stop();
        bench.begin(StudyParts::shapes);
        QCOMPARE(bench.run().state(), State::Break); // it was not over
        QVERIFY2(bench.said().startsWith("Participant 1 has done 2 of 4 trials. Feel a shape"),
                 qPrintable(bench.said()));
        bench.run().goOn();
        QCOMPARE(bench.run().trial(), QString("Trial 3 of 4"));
        bench.run().pause();
        bench.run().goOn(); // no second break
        QCOMPARE(bench.run().state(), State::Ready);
    }

    void a_trial_that_a_kill_took_is_told_the_next_time() {
        StudyParts bench;
        bench.begin(StudyParts::shapes);
        bench.start();
        QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(bench.study_folder() / study_running_file), 60000);
        bench.run().answer(0);
        bench.settle();
        QVERIFY(!std::filesystem::exists(bench.study_folder() / study_running_file));
        bench.run().stop(), bench.run().stop();
        QCOMPARE(note_running(bench.study_folder(), 1, 2), std::string()); // as if it had been killed
        bench.begin(StudyParts::shapes);
        QVERIFY2(bench.said().startsWith("A trial was running when the program ended; it is done again. "
                                         "Participant 1 has done 1 of 4 trials. Feel a shape"),
                 qPrintable(bench.said()));
        QCOMPARE(bench.run().trial(), QString("Trial 2 of 4"));
    }
};

} // namespace study_run_breaks_test

TP_TEST(study_run_breaks_test, StudyRunBreaksTest, event_loop)
#include "study_run_breaks_test.moc"
