// SPDX-License-Identifier: Apache-2.0
// What set-up, sitting, page and window have to do with each other.
#include "core/study_folder/running_trial.hpp"
#include "study_bench.hpp"
#include "test_program.hpp"

#include <QDir>

namespace study_session_test {

using namespace tp;
using State = StudyRun::State;

class StudySessionTest : public QObject {
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
    void the_set_up_knows_what_was_done_when_a_sitting_ends() {
        StudyBench bench;
        bench.begin(StudyBench::shapes);
        bench.name(0);
        bench.session->begin(); // one goes on
        QCOMPARE(bench.run().state(), State::Ready);
        QVERIFY(bench.session->stop());
        QVERIFY(bench.session->stop());
        QVERIFY2(bench.has_said("Everything is kept. Participant 1 has done 1 of 4 trials."),
                 qPrintable(bench.said()));
        QTRY_COMPARE_WITH_TIMEOUT(bench.session->setup()->progress(),
                                  QString("Participant 1 has done 1 of 4 trials."), 60000);
        QVERIFY(!bench.session->stop()); // the shell leads home
        bench.session->begin();
        bench.run().agree();
        QTRY_COMPARE_WITH_TIMEOUT(bench.run().state(), State::Ready, 60000);
        QCOMPARE(bench.run().trial(), QString("Trial 2 of 4"));
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
        bench.voice.clear();
        bench.session->setActive(true); // the window, with another page in it
        QVERIFY2(bench.voice.said().isEmpty(), qPrintable(bench.said()));
        bench.session->enter();
        QVERIFY2(bench.said().contains("Paused. Press Space to go on."), qPrintable(bench.said()));
        bench.run().goOn();
        QCOMPARE(bench.run().state(), State::Ready);
    }

    void that_the_scene_is_shown_is_never_remembered() {
        StudyBench bench;
        bench.set_up(StudyBench::shapes);
        bench.session->setup()->setShowScene(true);
        bench.session->begin();
        bench.run().agree();
        QVERIFY(bench.run().shown() != nullptr);
        bench.session->stop();
        bench.session->stop();
        QVERIFY(!QDir(bench.documents()).exists());
        QVERIFY(!bench.session->setup()->show_scene());
        QTRY_COMPARE_WITH_TIMEOUT(bench.session->setup()->problem(), QString(), 60000);
        bench.session->begin();
        bench.run().agree();
        QTRY_COMPARE_WITH_TIMEOUT(bench.run().state(), State::Ready, 60000);
        QVERIFY(bench.run().shown() == nullptr);
    }

    void a_trial_that_a_kill_took_is_told_in_the_set_up() {
        StudyBench bench;
        bench.begin(StudyBench::shapes);
        bench.name(0);
        bench.session->stop();
        bench.session->stop();
        QCOMPARE(note_running(bench.study_folder(), 1, 2), std::string()); // as if it had been killed
        bench.session->setup()->setParticipant(1);
        QTRY_COMPARE_WITH_TIMEOUT(
            bench.session->setup()->progress(),
            QString("Participant 1 has done 1 of 4 trials. A trial was running when the program "
                    "ended; it is done again."),
            60000);
    }
};

} // namespace study_session_test

TP_TEST(study_session_test, StudySessionTest, window)
#include "study_session_test.moc"
