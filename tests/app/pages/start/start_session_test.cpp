// SPDX-License-Identifier: Apache-2.0
#include "start_bench.hpp"
#include "test_program.hpp"

#include <QSignalSpy>

namespace start_session_test {

using namespace tp;

class StartSessionTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { StartBench::make_pictures_folder(); }

    void the_questions_come_first_and_then_the_two_main_things() {
        StartBench bench;
        StartSession& session = bench.session;
        session.enter();
        QVERIFY(session.asking());
        QVERIFY(bench.last_said().startsWith("Question 1 of 5."));
        session.go(0);
        QVERIFY(session.asking());
        bench.answer_until(Question::user);
        bench.questions().answer(0);
        bench.questions().answer(0);
        QVERIFY(!session.asking());
        QVERIFY(bench.last_said().startsWith(
            "TouchPhoto, start page. 1: Listen to photographs. 2: Feel a face."));
        session.askAgain();
        QVERIFY(session.asking());
        QVERIFY(bench.last_said().startsWith("Question 1 of 5."));
    }

    void what_is_new_is_told_once_it_is_known_whole() {
        StartBench bench;
        bench.preferences.change([](Choices& choices) { choices.asked = true; });
        StartSession session(bench.narrator, bench.preferences, [] { return std::vector<FoundDevice>(); });
        session.enter();
        session.know({}, false);
        const auto sentences = bench.voice.said().size();
        session.know({12, 3, 5}, true); // five of them are not looked at yet
        QCOMPARE(bench.voice.said().size(), sentences);
        QCOMPARE(session.news(), QString("12 new photograph(s), 3 with people."));
        session.know({12, 9, 0}, true);
        QCOMPARE(bench.last_said(), QString("12 new photograph(s), 9 with people."));
        session.know({12, 9, 0}, false);
        QCOMPARE(bench.voice.said().size(), sentences + 1);
        session.repeat();
        QVERIFY(
            bench.last_said().startsWith("TouchPhoto, start page. 12 new photograph(s), 9 with people. 1: "));
        session.leave();
        session.know({13, 9, 0}, false); // nobody is here
        QVERIFY(bench.last_said().startsWith("TouchPhoto, start page. 12 "));
        session.enter();
        QVERIFY(bench.last_said().startsWith("TouchPhoto, start page. 13 "));
        session.know({}, false);
        QCOMPARE(session.news(), QString());
    }

    void nobody_is_seen_where_nobody_looks() {
        StartBench bench;
        bench.preferences.change([](Choices& choices) { choices.asked = true; });
        StartSession session(bench.narrator, bench.preferences, [] { return std::vector<FoundDevice>(); });
        session.enter();
        session.know({2, 0, 2}, false);
        QCOMPARE(bench.last_said(), QString("2 new photograph(s)."));
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
        session.go(5);
        QCOMPARE(asked.takeFirst().first().toString(), QString("capture"));
        session.go(6);
        QCOMPARE(asked.takeFirst().first().toString(), QString("study"));
        session.go(77);
        QVERIFY(asked.isEmpty());
    }
};

} // namespace start_session_test

TP_TEST(start_session_test, StartSessionTest, event_loop)
#include "start_session_test.moc"
