// SPDX-License-Identifier: Apache-2.0
// What the researcher chooses, and what is said where it cannot be.
#include "device_socket.hpp"
#include "places.hpp"
#include "study_bench.hpp"
#include "test_program.hpp"

#include <QFileInfo>

namespace study_setup_test {

using namespace tp;
using State = StudyRun::State;

class StudySetupTest : public QObject {
    Q_OBJECT
private slots:
    void the_program_s_own_experiments_are_offered_by_title() {
        StudyBench bench;
        bench.session->enter();
        const StudySetup& setup = *bench.session->setup();
        QCOMPARE(setup.experiments(),
                 QStringList({"Following contours, by stiffness and range", "Naming shapes of three sizes",
                              "Naming the expressions of faces",
                              "Following contours by the exact and the published law",
                              "Naming expressions by the exact and the published law"}));
        QTRY_COMPARE_WITH_TIMEOUT(setup.problem(), QString(), 60000);
        QCOMPARE(setup.folder(), bench.documents() + "/tracking");
        QCOMPARE(setup.participant(), 1);
        QCOMPARE(setup.progress(), QString("Participant 1 is new."));
        QVERIFY2(bench.said().startsWith("Studies. Following contours, by stiffness and range."),
                 qPrintable(bench.said()));
        QVERIFY(!QDir(bench.documents()).exists());
    }

    void a_file_that_is_no_experiment_is_said_and_the_choice_stays() {
        StudyBench bench;
        bench.set_up(StudyBench::lines);
        QFile file(bench.folder.filePath("wrong.study"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("experiment: wrong\ntask: dance\n");
        file.close();
        bench.session->setup()->openFile(QUrl::fromLocalFile(file.fileName()));
        QVERIFY2(bench.said().startsWith("wrong.study cannot be used as an experiment."),
                 qPrintable(bench.said()));
        bench.session->setup()->openFile(QUrl::fromLocalFile(bench.folder.filePath("nowhere.study")));
        QVERIFY2(bench.said().contains("nowhere.study"), qPrintable(bench.said()));
        bench.session->setup()->openFile(QUrl("https://example.org/a.study"));
        QCOMPARE(bench.said(), QString("Only a file on this computer can be opened."));
        QCOMPARE(bench.session->setup()->experiments().size(), 6);
        QCOMPARE(bench.session->setup()->experiments().back(), QString("Two lines"));
        QCOMPARE(bench.session->setup()->experiment_index(), 5);
    }

    void more_answers_than_keys_are_refused() {
        StudyBench bench;
        bench.set_up(StudyBench::lines);
        QFile file(bench.folder.filePath("many.study"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("experiment: many\ntask: name\nfactor radius: 10, 11, 12, 13, 14, 15, 16, 17, 18, 19 mm\n"
                   "set shape: circle\nanswer: radius\n");
        file.close();
        bench.session->setup()->openFile(QUrl::fromLocalFile(file.fileName()));
        QCOMPARE(bench.said(), QString("The experiment has more than 9 answers, which have no keys."));
    }

    void the_next_participant_is_offered_and_an_earlier_one_goes_on() {
        StudyBench bench;
        bench.begin(StudyBench::shapes);
        bench.start();
        bench.run().answer(0);
        bench.settle();
        bench.session->stop();
        bench.session->stop();
        bench.session->setup()->choose(0);
        bench.session->setup()->choose(5);
        QTRY_COMPARE_WITH_TIMEOUT(bench.session->setup()->participant(), 2, 60000);
        QTRY_COMPARE_WITH_TIMEOUT(bench.session->setup()->progress(), QString("Participant 2 is new."),
                                  60000);
        bench.session->setup()->setParticipant(1);
        QTRY_COMPARE_WITH_TIMEOUT(bench.session->setup()->progress(),
                                  QString("Participant 1 has done 1 of 4 trials."), 60000);
        bench.session->setup()->setParticipant(0);
        QCOMPARE(bench.said(), QString("Participants have numbers from 1 to 9999."));
        QCOMPARE(bench.session->setup()->participant(), 1);
    }

    void a_participant_s_number_is_typed() {
        StudyBench bench;
        bench.set_up(StudyBench::shapes);
        bench.session->setup()->typeParticipant(" 37 ");
        QCOMPARE(bench.session->setup()->participant(), 37);
        QCOMPARE(bench.said(), QString("Participant 37"));
        for (const char* wrong : {"", "Anna", "0", "-3", "10000", "2.5"}) {
            bench.session->setup()->typeParticipant(wrong);
            QCOMPARE(bench.said(), QString("Participants have numbers from 1 to 9999."));
            QCOMPARE(bench.session->setup()->participant(), 37);
        }
    }

    void a_folder_with_another_study_is_refused_in_a_sentence() {
        StudyBench bench;
        bench.begin(StudyBench::shapes);
        bench.session->stop();
        bench.session->stop();
        QVERIFY(QFileInfo::exists(bench.documents() + "/shapes/protocol.study"));
        QFile file(bench.folder.filePath("other.study"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            "experiment: shapes\ntask: name\nfactor shape: circle, square\nanswer: shape\nrepetitions: 3\n");
        file.close();
        bench.session->setup()->openFile(QUrl::fromLocalFile(file.fileName()));
        QTRY_COMPARE_WITH_TIMEOUT(
            bench.session->setup()->problem(),
            QString("In this folder lies a study of another experiment, or of another version of it. "
                    "Choose another folder."),
            60000);
        bench.session->begin();
        QCOMPARE(bench.run().state(), State::SetUp);
    }

    void faces_come_from_a_folder_of_the_researcher() {
        StudyBench bench;
        bench.session->enter();
        bench.session->setup()->choose(2);
        QVERIFY(bench.session->setup()->needs_faces());
        QTRY_VERIFY_WITH_TIMEOUT(bench.session->setup()->problem().startsWith("This experiment needs faces."),
                                 60000);
        bench.session->begin();
        QCOMPARE(bench.run().state(), State::SetUp);
        QVERIFY(bench.said().startsWith("This experiment needs faces."));
        bench.session->setup()->chooseFaces();
        QVERIFY(bench.session->setup()->choosing());
        emit bench.session->setup()->chooser()->chosen(
            QString::fromStdString(test::in_source("resources/samples")));
        QVERIFY(!bench.session->setup()->choosing());
        QTRY_VERIFY_WITH_TIMEOUT(
            bench.session->setup()->problem().contains("too few people with every expression: 1"), 60000);
    }

    void a_pull_above_the_person_s_limit_is_said_and_asked_for() {
        StudyBench bench;
        bench.session->enter();
        StudySetup& setup = *bench.session->setup();
        const QString cut =
            "This study asks for up to 5.0 newtons. The force is cut at 1.0 newtons, in 45 of 75 "
            "conditions, unless you consent to more. Key: L.";
        QTRY_COMPARE_WITH_TIMEOUT(setup.problem(), QString(), 60000);
        QCOMPARE(setup.force(), cut);
        QVERIFY2(bench.said().endsWith(cut), qPrintable(bench.said())); // who comes to the page hears it
        QVERIFY(!setup.plan()->force_allowed);
        setup.setForceAllowed(true);
        const QString raised =
            "The force may reach 5.0 newtons, as far as the device gives it, with your consent.";
        QCOMPARE(bench.said(), raised);
        QCOMPARE(setup.force(), raised);
        QVERIFY(setup.plan()->force_allowed);
        setup.choose(1); // no more than 0.8 N
        QCOMPARE(setup.force(), QString());
        QVERIFY(!setup.force_allowed());
        setup.setForceAllowed(true);
        QCOMPARE(bench.said(), QString("This study asks for no more force than the settings allow."));
        QVERIFY(!setup.force_allowed());
        setup.choose(0);
        QCOMPARE(setup.force(), cut); // asked for again
        setup.setForceAllowed(true);
        bench.session->leave();
        QVERIFY(!setup.force_allowed());
    }

    void escape_ends_choosing_a_folder() {
        StudyBench bench;
        bench.set_up(StudyBench::lines);
        bench.session->setup()->chooseFolder();
        QVERIFY(bench.session->setup()->choosing());
        QVERIFY(bench.session->stop());
        QVERIFY(!bench.session->setup()->choosing());
        bench.session->setup()->chooseFolder();
        emit bench.session->setup()->chooser()->chosen(bench.folder.filePath("elsewhere"));
        QCOMPARE(bench.session->setup()->folder(), bench.folder.filePath("elsewhere"));
    }

    void a_device_is_offered_where_there_is_one() {
        tp::testing::DeviceSocket socket;
        StudyBench bench(socket.access());
        bench.session->enter();
        QCOMPARE(bench.session->setup()->hands(), QStringList({"Mouse, touch or keys, with a tone"}));
        QCOMPARE(bench.session->setup()->hand(), 0);
        socket.plug_in();
        QTRY_COMPARE_WITH_TIMEOUT(bench.session->setup()->hands().size(), 2, 60000);
        QCOMPARE(bench.session->setup()->hand(), 0);
        bench.session->setup()->chooseHand(1);
        QCOMPARE(bench.session->setup()->hand(), 1);
    }
};

} // namespace study_setup_test

TP_TEST(study_setup_test, StudySetupTest, window)
#include "study_setup_test.moc"
