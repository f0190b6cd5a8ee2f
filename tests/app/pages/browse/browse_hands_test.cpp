// SPDX-License-Identifier: Apache-2.0
#include "browse_page.hpp"
#include "page_test.hpp"
#include "test_program.hpp"

#include <QCoreApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QPoint>
#include <QQuickItem>
#include <QSignalSpy>
#include <QTest>

namespace browse_hands_test {

using namespace tp;
using namespace tp::testing;
using View = BrowseTrail::View;

class BrowseHandsTest : public PageTest {
    Q_OBJECT
private slots:
    void arrow_keys() {
        Page page;
        QVERIFY(page.ready());
        page.key(Qt::Key_Right);
        QCOMPARE(page.said(), QString("Anna and Ben, June 2026; 1 recording(s)."));
        page.key(Qt::Key_Left);
        QCOMPARE(page.said(), garden_words);
        page.key(Qt::Key_Down);
        QCOMPARE(page.said(), QString("Anna"));
        QVERIFY(PageWindow::named(page.window, "Detail: Anna") != nullptr);
        page.key(Qt::Key_Up);
        QCOMPARE(page.said(), garden_words);
        page.key(Qt::Key_Home);
        QCOMPARE(page.session->trail()->position(), 1);
        page.key(Qt::Key_End);
        QCOMPARE(page.session->trail()->position(), 5);
    }

    void return_plays_and_pauses_and_escape_stops_once() {
        Page page;
        QVERIFY(page.ready());
        page.key(Qt::Key_Return);
        QVERIFY(page.session->playback()->playing());
        page.loudspeaker.play(0.2);
        QVERIFY(PageWindow::named(page.window, "Pause") != nullptr);
        QVERIFY(PageWindow::named(page.window, "memo by Tom, 0:00 of 0:01") != nullptr);
        page.key(Qt::Key_Return);
        QVERIFY(!page.session->playback()->playing());
        page.key(Qt::Key_Space);
        QVERIFY(page.session->playback()->playing());
        page.key(Qt::Key_Escape);
        QVERIFY(!page.session->playback()->playing());
        QVERIFY(PageWindow::named(page.window, "Play recordings") != nullptr);
    }

    void an_escape_that_stops_nothing_is_left_to_the_program() {
        Page page;
        QVERIFY(page.ready());
        const auto escape = [&] {
            QKeyEvent event(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
            event.ignore();
            QCoreApplication::sendEvent(&page.window, &event);
            return event.isAccepted();
        };
        page.key(Qt::Key_Return);
        QVERIFY(escape());
        QVERIFY(!escape());
    }

    void other_keys() {
        Page page;
        QVERIFY(page.ready());
        QSignalSpy explore(page.session.get(), &BrowseSession::exploreAsked),
            care(page.session.get(), &BrowseSession::careAsked);
        page.key(Qt::Key_W);
        QCOMPARE(page.said(), "All photographs, 4 of 5: " + garden_words);
        page.key(Qt::Key_Plus);
        QCOMPARE(page.said(), QString("Speed 1.25"));
        page.key(Qt::Key_Minus);
        QCOMPARE(page.said(), QString("Speed 1"));
        page.key(Qt::Key_E);
        page.key(Qt::Key_C);
        QCOMPARE(explore.count(), 1);
        QCOMPARE(care.count(), 1);
        page.key(Qt::Key_H);
        QVERIFY(page.said().startsWith("Left and right"));
        page.key(Qt::Key_R);
        QVERIFY(page.session->trail()->position() != 4);
        page.key(Qt::Key_Y);
        QCOMPARE(page.session->trail()->title(), QString("Years"));
        page.key(Qt::Key_L);
        QCOMPARE(page.session->trail()->title(), QString("Places"));
        page.key(Qt::Key_K);
        QCOMPARE(page.session->trail()->title(), QString("Keywords"));
        page.key(Qt::Key_A);
        QCOMPARE(page.session->trail()->title(), QString("All photographs"));
    }

    void a_list_by_keys_alone() {
        Page page;
        QVERIFY(page.ready());
        page.key(Qt::Key_P);
        QCOMPARE(page.session->trail()->view(), View::Names);
        QCOMPARE(page.said(), QString("Anna, 2 photograph(s)")); // the row that has the keyboard
        QVERIFY(PageWindow::named(page.window, "Anna, 2 photograph(s), 1 of 3") != nullptr);
        page.key(Qt::Key_Down);
        QCOMPARE(page.said(), QString("Ben, 1 photograph(s)"));
        page.key(Qt::Key_Up);
        page.key(Qt::Key_Return);
        QCOMPARE(page.session->trail()->title(), QString("Anna"));
        QVERIFY(page.item("pane")->hasActiveFocus());
        page.key(Qt::Key_Right);
        QCOMPARE(page.session->trail()->position(), 2);
        page.key(Qt::Key_Backspace);
        QCOMPARE(page.session->trail()->view(), View::Names);
        QCOMPARE(page.said(), QString("Anna, 2 photograph(s)"));
        page.key(Qt::Key_End);
        QCOMPARE(page.said(), QString("Tom, 1 photograph(s)"));
        page.key(Qt::Key_Backspace);
        QCOMPARE(page.session->trail()->view(), View::Photos);
        QVERIFY(page.item("pane")->hasActiveFocus());
    }

    void a_list_by_buttons_that_stay_where_they_are() {
        Page page;
        QVERIFY(page.ready());
        QVERIFY(act(page.window, "Years"));
        QCOMPARE(page.said(), QString("2026, 2 photograph(s)"));
        QVERIFY(act(page.window, "Down"));
        QCOMPARE(page.said(), QString("2025, 2 photograph(s)"));
        QVERIFY(act(page.window, "Down"));
        QVERIFY(act(page.window, "Down"));
        QCOMPARE(page.said(), QString("2024, 1 photograph(s)"));
        QVERIFY(act(page.window, "Up"));
        QVERIFY(act(page.window, "Choose"));
        QCOMPARE(page.session->trail()->title(), QString("2025"));
    }

    void the_keyboard_stays_on_its_row_when_the_list_grows() {
        Page page;
        QVERIFY(page.ready());
        page.key(Qt::Key_P);
        page.key(Qt::Key_Down);
        QCOMPARE(page.said(), QString("Ben, 1 photograph(s)"));
        page.drawn.name(page.five.sea, "Zoe", 0.5);
        page.drawn.album->touched(page.five.sea);
        QTRY_COMPARE(page.session->lists()->rows().size(), 4);
        QTRY_VERIFY(page.window.activeFocusItem() != nullptr &&
                    page.window.activeFocusItem()->property("text").toString() == "Ben");
        page.key(Qt::Key_Return);
        QCOMPARE(page.session->trail()->title(), QString("Ben"));
    }

    void a_search_by_keys_alone() {
        Page page;
        QVERIFY(page.ready());
        page.key(Qt::Key_S);
        page.words("Tom");
        QCOMPARE(page.session->lists()->typed(), QString("Tom"));
        page.key(Qt::Key_Backspace);
        page.key(Qt::Key_Return);
        QCOMPARE(page.session->lists()->typed(), QString("To"));
        QCOMPARE(page.said(), QString("2 photograph(s), 1 suggestion(s).")); // the tower too
        page.key(Qt::Key_Down);
        QCOMPARE(page.said(), QString("Tom, person, 1 photograph(s)"));
        page.key(Qt::Key_Down);
        page.key(Qt::Key_Up);
        page.key(Qt::Key_Up);
        page.words("m");
        QCOMPARE(page.session->lists()->typed(), QString("Tom"));
        page.key(Qt::Key_Down);
        page.key(Qt::Key_Return);
        QCOMPARE(page.session->trail()->title(), QString("Tom"));
        QCOMPARE(page.session->trail()->count(), 1);
    }

    void swipes_go_the_way_of_the_arrow_keys() {
        Page page;
        QVERIFY(page.ready());
        page.swipe(150, 5);
        QCOMPARE(page.session->trail()->position(), 5);
        page.swipe(-150, -5);
        QCOMPARE(page.session->trail()->position(), 4);
        page.swipe(5, 150);
        QCOMPARE(page.said(), QString("Anna"));
        page.swipe(-5, -150);
        QCOMPARE(page.said(), garden_words);
    }

    void one_tap_tells_two_play_and_two_more_pause() {
        Page page;
        QVERIFY(page.ready());
        page.key(Qt::Key_Down);
        page.voice.clear();
        page.tap();
        QCOMPARE(page.said(), QString("Anna"));
        page.tap();
        QVERIFY(page.session->playback()->playing());
        page.loudspeaker.play(0.1);
        page.tap();
        QVERIFY(page.session->playback()->playing());
        page.tap();
        QVERIFY(!page.session->playback()->playing());
    }

    void two_fingers_play_stop_and_go_back_and_three_tell() {
        Page page;
        QVERIFY(page.ready());
        page.tap(2);
        page.tap(2);
        QVERIFY(page.session->playback()->playing());
        page.tap(2);
        QVERIFY(!page.session->playback()->playing());
        page.tap(3);
        QVERIFY(page.said().startsWith("All photographs, 4 of 5"));
        page.session->lists()->openTopic(BrowseLists::Topic::People);
        page.session->lists()->choose(0);
        const QPoint from = page.middle() - QPoint(60, 60);
        QSignalSpy zs(page.item("gestures"), SIGNAL(drawnZ()));
        page.draw({from, from + QPoint(120, 0), from + QPoint(0, 60), from + QPoint(120, 60)}, 2);
        QCOMPARE(zs.count(), 1);
        QCOMPARE(page.session->trail()->view(), View::Names);
    }

    void the_mouse_is_one_finger() {
        Page page;
        QVERIFY(page.ready());
        QTest::mousePress(&page.window, Qt::LeftButton, {}, page.middle());
        QTest::mouseMove(&page.window, page.middle() + QPoint(70, 0));
        QTest::mouseMove(&page.window, page.middle() + QPoint(150, 0));
        QTest::mouseRelease(&page.window, Qt::LeftButton, {}, page.middle() + QPoint(150, 0));
        QCOMPARE(page.session->trail()->position(), 5);
    }

    void a_double_click_plays() {
        Page page;
        QVERIFY(page.ready());
        QTest::mouseDClick(&page.window, Qt::LeftButton, {}, page.middle());
        QVERIFY(page.session->playback()->playing());
        page.loudspeaker.play(0.1);
        QTest::mouseMove(&page.window, page.middle() + QPoint(9, 9));
        QVERIFY(page.session->playback()->playing());
    }
};

} // namespace browse_hands_test

TP_TEST(browse_hands_test, BrowseHandsTest, window)
#include "browse_hands_test.moc"
