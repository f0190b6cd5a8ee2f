// SPDX-License-Identifier: Apache-2.0
#include "app/pages/start/start_module.hpp"
#include "page_test.hpp"
#include "page_window.hpp"
#include "start_bench.hpp"
#include "test_program.hpp"

#include <QPoint>
#include <QPointingDevice>
#include <QSignalSpy>

namespace start_page_test {

using namespace tp;

class StartPageTest : public PageTest {
    Q_OBJECT
private slots:
    void initTestCase() {
        StartBench::make_pictures_folder();
        register_start();
    }

    void the_questions_are_answered_by_number_keys_alone() {
        StartBench bench;
        PageWindow window(page, &bench.session);
        QVERIFY(window.exposed());
        bench.session.enter();
        for (const Qt::Key key : {Qt::Key_1, Qt::Key_2, Qt::Key_1, Qt::Key_1, Qt::Key_3})
            QTest::keyClick(&window, key);
        QVERIFY(!bench.session.asking());
        QCOMPARE(bench.now().rate, Choices::Rate::slow);
        QSignalSpy asked(&bench.session, &StartSession::pageAsked);
        QTest::keyClick(&window, Qt::Key_2);
        QCOMPARE(asked.count(), 1);
    }

    void they_are_answered_by_a_screen_reader_alone() {
        StartBench bench;
        PageWindow window(page, &bench.session);
        QVERIFY(window.exposed());
        bench.session.enter();
        for (const char* answer :
             {"3: No, my screen reader speaks", "4: Fast", "1: Somebody who listens and feels",
              "1: Continue without a device", "3: Ask me later"}) {
            QTRY_VERIFY2(window.named(answer) != nullptr, answer);
            QCOMPARE(window.faulty_targets().join("; "), QString());
            QVERIFY(window.press(answer));
        }
        QVERIFY(!bench.session.asking());
        QTRY_VERIFY(
            window.named(
                "1: Listen to photographs, One photograph after the other, with what was recorded for it") !=
            nullptr);
        QCOMPARE(window.faulty_targets().join("; "), QString());
    }

    void they_are_answered_by_taps_alone_and_a_tap_beside_repeats() {
        StartBench bench;
        PageWindow window(page, &bench.session, {600, 1000});
        QVERIFY(window.exposed());
        bench.session.enter();
        QPointingDevice* screen = QTest::createTouchDevice();
        const auto tap = [&](QPoint at) {
            QTest::touchEvent(&window, screen).press(0, at);
            QTest::touchEvent(&window, screen).release(0, at);
        };
        const qsizetype said = bench.voice.said().size();
        tap({590, 990});
        QCOMPARE(bench.voice.said().size(), said + 1);
        for (int i = 0; i < 3; ++i) {
            QAccessibleInterface* answer = window.named(i == 1   ? "3: At the usual speed"
                                                        : i == 0 ? "1: Yes"
                                                                 : "1: Somebody who listens and feels");
            QVERIFY(answer != nullptr);
            auto* item = qobject_cast<QQuickItem*>(answer->object());
            tap(item->mapToScene({item->width() / 2, item->height() / 2}).toPoint());
            QCOMPARE(bench.questions().number(), i + 2);
        }
    }

    void an_answer_has_the_keyboard_on_every_question() {
        StartBench bench;
        PageWindow window(page, &bench.session);
        QVERIFY(window.exposed());
        for (int i = 0; i < 3; ++i) {
            QAccessibleInterface* focused = QAccessible::queryAccessibleInterface(window.activeFocusItem());
            QVERIFY(focused != nullptr && focused->role() == QAccessible::Button);
            QTest::keyClick(&window, Qt::Key_Return);
            QCOMPARE(bench.questions().number(), i + 2);
        }
    }

    void backspace_goes_back_and_at_the_first_leaves_the_key_to_others() {
        StartBench bench;
        PageWindow window(page, &bench.session);
        QVERIFY(window.exposed());
        QTest::keyClick(&window, Qt::Key_1);
        QTest::keyClick(&window, Qt::Key_Backspace);
        QCOMPARE(bench.questions().number(), 1);
        QTest::keyClick(&window, Qt::Key_R);
        QVERIFY(bench.last_said().startsWith("Question 1"));
    }

    void a_caregiver_sees_the_folders_in_a_list() {
        StartBench bench;
        PageWindow window(page, &bench.session);
        QVERIFY(window.exposed());
        bench.answer_until(Question::device);
        QVERIFY(window.press("2: In another folder"));
        bench.questions().chooser()->begin_in("/");
        QTRY_VERIFY(window.named("Choose this folder") != nullptr);
        QVERIFY(window.named("Up one folder, not available") != nullptr);
        QCOMPARE(window.faulty_targets().join("; "), QString());
        QTest::keyClick(&window, Qt::Key_Escape);
        QTRY_VERIFY(window.named("2: In another folder") != nullptr);
    }

private:
    const QString page = "Start/StartPage.qml";
};

} // namespace start_page_test

TP_TEST(start_page_test, StartPageTest, window)
#include "start_page_test.moc"
