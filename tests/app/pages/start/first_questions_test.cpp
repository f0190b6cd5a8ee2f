// SPDX-License-Identifier: Apache-2.0
#include "start_bench.hpp"
#include "test_program.hpp"

#include <QSignalSpy>

namespace first_questions_test {

using namespace tp;

class FirstQuestionsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { StartBench::make_pictures_folder(); }

    void five_questions_are_asked_answered_and_kept() {
        StartBench bench;
        FirstQuestions& questions = bench.questions();
        QSignalSpy ended(&questions, &FirstQuestions::ended);
        questions.go_on();
        QVERIFY(questions.asking());
        QCOMPARE(bench.last_said(),
                 QString("Question 1 of 5. Should TouchPhoto speak? 1: Yes. 2: No, the words on "
                         "the screen are enough. 3: No, my screen reader speaks."));
        questions.answer(0);
        QVERIFY(bench.last_said().startsWith("Question 2 of 5. How fast"));
        questions.answer(3);
        QCOMPARE(bench.now().rate, Choices::Rate::fast);
        questions.answer(1);
        QCOMPARE(bench.now().user, Choices::User::caregiver);
        QVERIFY(bench.last_said().contains("Looking for a force device"));
        QTRY_VERIFY(bench.last_said().contains("No force device was found"));
        questions.answer(0);
        QVERIFY(
            bench.last_said().startsWith("Question 5 of 5. Where are your photographs? 1: In the folder /"));
        QVERIFY(!bench.now().asked);
        questions.answer(0);
        QVERIFY(!questions.asking());
        QVERIFY(bench.now().asked);
        QCOMPARE(bench.now().folders, QStringList(FolderChooser::pictures_folder()));
        QCOMPARE(ended.count(), 1);
        QVERIFY(bench.last_said().startsWith(
            "TouchPhoto, start page. 1: Look after the album. 2: Listen to photographs."));
    }

    void who_wants_the_screen_reader_or_nobody_gets_that() {
        for (const auto& [answer, voice] :
             {std::pair{1, Choices::Voice::off}, {2, Choices::Voice::screen_reader}}) {
            StartBench bench;
            bench.questions().answer(answer);
            QCOMPARE(bench.now().voice, voice);
            QCOMPARE(bench.questions().number(), 2);
        }
    }

    void one_can_go_back_and_answer_anew_and_hear_it_again() {
        StartBench bench;
        bench.questions().go_on();
        QVERIFY(!bench.questions().back());
        bench.questions().answer(0);
        bench.questions().answer(4);
        QVERIFY(bench.questions().back());
        QCOMPARE(bench.questions().current(), 4);
        const QString question = bench.last_said();
        bench.voice.clear();
        bench.questions().repeat();
        QCOMPARE(bench.last_said(), question);
        bench.questions().answer(1);
        QCOMPARE(bench.now().rate, Choices::Rate::slow);
        bench.questions().answer(99);
        bench.questions().answer(-1);
        QCOMPARE(bench.questions().number(), 3);
    }

    void a_device_that_is_found_is_named_and_remembered_and_one_can_look_again() {
        StartBench bench(std::vector<FoundDevice>{{"a force pad with the serial number TP-7", "TP-7"}});
        bench.answer_until(Question::user);
        QTRY_VERIFY(bench.last_said().contains(
            "A force device was found: a force pad with the serial number TP-7. 1: Use this device."));
        bench.devices.clear();
        bench.questions().answer(1);
        QTRY_VERIFY(bench.last_said().contains("No force device was found"));
        QCOMPARE(bench.looked, 2);
        bench.devices = {{"a force pad", "TP-8"}};
        bench.questions().answer(1);
        QTRY_VERIFY(bench.last_said().contains("a force pad. 1: Use this device"));
        bench.questions().answer(0);
        QCOMPARE(bench.now().device, QString("TP-8"));
    }

    void another_folder_is_chosen_or_none() {
        StartBench bench;
        bench.answer_until(Question::device);
        bench.questions().answer(1);
        QVERIFY(bench.questions().choosing());
        QVERIFY(bench.last_said().startsWith("Folder "));
        QVERIFY(bench.questions().back());
        QVERIFY(bench.last_said().startsWith("Question 5 of 5."));
        bench.questions().answer(1);
        bench.questions().chooser()->begin_in("/usr");
        bench.questions().chooser()->choose();
        QCOMPARE(bench.now().folders, QStringList("/usr"));
        QVERIFY(!bench.questions().asking());
        bench.questions().begin();
        QVERIFY(bench.questions().asking());
        bench.answer_until(Question::device);
        bench.questions().answer(2);
        QVERIFY(!bench.questions().asking());
        QCOMPARE(bench.now().folders, QStringList("/usr"));
    }

    void the_program_can_end_while_it_looks_for_a_device() {
        StartBench bench;
        bench.answer_until(Question::user);
    }
};

} // namespace first_questions_test

TP_TEST(first_questions_test, FirstQuestionsTest, event_loop)
#include "first_questions_test.moc"
