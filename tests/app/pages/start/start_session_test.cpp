// SPDX-License-Identifier: Apache-2.0
#include "start_bench.hpp"

#include <QSignalSpy>

using namespace tp;

class StartSessionTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { StartBench::make_pictures_folder(); }

    void five_questions_are_asked_answered_and_kept() {
        StartBench bench;
        StartSession& session = bench.session;
        session.enter();
        QVERIFY(session.asking());
        QCOMPARE(bench.last_said(), QString("Question 1 of 5. Shall TouchPhoto speak to you? 1: Yes. 2: No, the words on "
                                            "the screen are enough. 3: My screen reader shall speak."));
        session.answer(0);
        QVERIFY(bench.last_said().startsWith("Question 2 of 5. How fast"));
        session.answer(3);
        QCOMPARE(bench.now().rate, Choices::Rate::fast);
        session.answer(1);
        QCOMPARE(bench.now().user, Choices::User::caregiver);
        QVERIFY(bench.last_said().contains("Looking for a force device"));
        QTRY_VERIFY(bench.last_said().contains("No force device was found"));
        session.answer(0);
        QVERIFY(bench.last_said().startsWith("Question 5 of 5. Where are your photographs? 1: In the folder /"));
        QVERIFY(!bench.now().asked);
        session.answer(0);
        QVERIFY(!session.asking());
        QVERIFY(bench.now().asked);
        QCOMPARE(bench.now().folders, QStringList(FolderChooser::pictures_folder()));
        QVERIFY(bench.last_said().startsWith("TouchPhoto, start page. 1: Look after the album. 2: Listen to photographs."));
    }

    void who_wants_the_screen_reader_or_nobody_gets_that() {
        for (const auto& [answer, voice] : {std::pair{1, Choices::Voice::off}, {2, Choices::Voice::screen_reader}}) {
            StartBench bench;
            bench.session.answer(answer);
            QCOMPARE(bench.now().voice, voice);
            QCOMPARE(bench.session.number(), 2);
        }
    }

    void one_can_go_back_and_answer_anew_and_hear_it_again() {
        StartBench bench;
        bench.session.enter();
        QVERIFY(!bench.session.back());
        bench.session.answer(0);
        bench.session.answer(4);
        QVERIFY(bench.session.back());
        QCOMPARE(bench.session.current(), 4);
        const QString question = bench.last_said();
        bench.voice.clear();
        bench.session.repeat();
        QCOMPARE(bench.last_said(), question);
        bench.session.answer(1);
        QCOMPARE(bench.now().rate, Choices::Rate::slow);
        bench.session.answer(99);
        bench.session.answer(-1);
        QCOMPARE(bench.session.number(), 3);
    }

    void a_device_that_is_found_is_named_and_remembered_and_one_can_look_again() {
        StartBench bench(std::vector<FoundDevice>{{"a force pad with the serial number TP-7", "TP-7"}});
        bench.answer_until(Question::user);
        QTRY_VERIFY(bench.last_said().contains("A force device was found: a force pad with the serial number TP-7. 1: Use it."));
        bench.devices.clear();
        bench.session.answer(1);
        QTRY_VERIFY(bench.last_said().contains("No force device was found"));
        QCOMPARE(bench.looked, 2);
        bench.devices = {{"a force pad", "TP-8"}};
        bench.session.answer(1);
        QTRY_VERIFY(bench.last_said().contains("a force pad. 1: Use it"));
        bench.session.answer(0);
        QCOMPARE(bench.now().device, QString("TP-8"));
    }

    void another_folder_is_chosen_or_none() {
        StartBench bench;
        bench.answer_until(Question::device);
        bench.session.answer(1);
        QVERIFY(bench.session.choosing());
        QVERIFY(bench.last_said().startsWith("Folder "));
        QVERIFY(bench.session.back());
        QVERIFY(bench.last_said().startsWith("Question 5 of 5."));
        bench.session.answer(1);
        bench.session.chooser()->begin_in("/usr");
        bench.session.chooser()->choose();
        QCOMPARE(bench.now().folders, QStringList("/usr"));
        QVERIFY(!bench.session.asking());
        bench.session.askAgain();
        QVERIFY(bench.session.asking());
        bench.answer_until(Question::device);
        bench.session.answer(2);
        QVERIFY(!bench.session.asking());
        QCOMPARE(bench.now().folders, QStringList("/usr"));
    }

    void the_two_main_things_depend_on_who_uses_it() {
        StartBench bench;
        bench.preferences.change([](Choices& choices) { choices.asked = true; });
        RecordingVoice voice;
        Narrator narrator(voice, bench.announcer);
        StartSession session(narrator, bench.preferences, [] { return std::vector<FoundDevice>(); });
        session.enter();
        QCOMPARE(voice.said(),
                 QStringList("TouchPhoto, start page. 1: Listen to photographs. 2: Feel a face. More below; F1 for help."));
        QSignalSpy asked(&session, &StartSession::pageAsked);
        session.go(0);
        session.go(1);
        QCOMPARE(asked.takeFirst().first().toString(), QString("browse"));
        QCOMPARE(asked.takeFirst().first().toString(), QString("explore"));
        session.go(5); // not there yet
        QVERIFY(voice.said().back().contains("Not there yet"));
        session.go(77);
        QVERIFY(asked.isEmpty());
    }

    void the_program_can_end_while_it_looks_for_a_device() {
        StartBench bench;
        bench.answer_until(Question::user);
    }
};

QTEST_GUILESS_MAIN(StartSessionTest)
#include "start_session_test.moc"
