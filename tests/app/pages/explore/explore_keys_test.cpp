// SPDX-License-Identifier: Apache-2.0
#include "explore_page.hpp"
#include "page_test.hpp"
#include "test_program.hpp"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineF>
#include <QPointingDevice>
#include <QTest>

namespace explore_keys_test {

using namespace tp;

/// What the page does for keys, the mouse and fingers on the screen.
class ExploreKeysTest : public PageTest {
    Q_OBJECT
private slots:
    void initTestCase() { register_explore(); }

    void the_mouse_moves_the_hand_and_the_line_draws_the_finger() {
        Page page;
        QVERIFY(page.exposed());
        QTest::mouseMove(&page.window, page.pixel(page.beside(20.0)));
        QTest::mouseMove(&page.window, page.pixel(page.beside()));
        QTRY_VERIFY(QLineF(page.session.finger()->pointer(), page.beside()).length() < 0.5);
        const double hand =
            distance_to_feature(page.session, Page::outline, page.session.finger()->pointer());
        QTRY_VERIFY(distance_to_feature(page.session, Page::outline, page.session.finger()->place()) <
                    hand - 1.0);
        QTRY_VERIFY(page.session.finger()->newtons() > 0.2);
    }

    void a_touch_moves_the_hand_and_the_line_draws_the_finger() {
        Page page;
        QVERIFY(page.exposed());
        QPointingDevice* screen = QTest::createTouchDevice();
        QTest::touchEvent(&page.window, screen).press(0, page.pixel(page.beside(20.0)), &page.window);
        QTRY_VERIFY(QLineF(page.session.finger()->pointer(), page.beside(20.0)).length() < 0.5);
        for (double higher = 19.0; higher >= 0.0; higher -= 1.0)
            QTest::touchEvent(&page.window, screen).move(0, page.pixel(page.beside(higher)), &page.window);
        QTRY_VERIFY(QLineF(page.session.finger()->pointer(), page.beside()).length() < 0.5);
        const double hand =
            distance_to_feature(page.session, Page::outline, page.session.finger()->pointer());
        QTRY_VERIFY(distance_to_feature(page.session, Page::outline, page.session.finger()->place()) <
                    hand - 1.0);
        QTest::touchEvent(&page.window, screen).release(0, page.pixel(page.beside()), &page.window);
    }

    void arrow_keys_move_the_hand() {
        Page page;
        QVERIFY(page.exposed());
        const QPointF before = page.session.finger()->pointer();
        QTest::keyClick(&page.window, Qt::Key_Right);
        QTest::keyClick(&page.window, Qt::Key_Down, Qt::ShiftModifier);
        QTRY_VERIFY(QLineF(page.session.finger()->pointer(), before + QPointF(2.0, 10.0)).length() < 1e-9);
    }

    void space_starts_a_tour_and_it_finishes() {
        Page page;
        QVERIFY(page.exposed());
        QTest::keyClick(&page.window, Qt::Key_Tab);
        QTest::keyClick(&page.window, Qt::Key_Space);
        QVERIFY(page.session.tour()->touring());
        QCOMPARE(page.voice.said().back(), QString("Tour round the left eye."));
        QTRY_VERIFY_WITH_TIMEOUT(!page.session.tour()->touring(), 60000);
        QCOMPARE(page.voice.said().back(), QString("Tour finished."));
    }

    void escape_gives_zero_force_and_enter_brings_it_back() {
        Page page;
        QVERIFY(page.exposed());
        QTest::mouseMove(&page.window, page.pixel(page.beside(20.0))); // from wherever another test left it
        QTest::mouseMove(&page.window, page.pixel(page.beside()));
        QTRY_VERIFY(page.session.finger()->newtons() > 0.1);
        QTest::keyClick(&page.window, Qt::Key_Escape);
        QTRY_COMPARE(page.session.finger()->newtons(), 0.0);
        QVERIFY(!page.session.device()->engaged());
        QTest::keyClick(&page.window, Qt::Key_Return);
        QVERIFY(page.session.device()->engaged());
        QTRY_VERIFY(page.session.finger()->newtons() > 0.1);
    }

    void other_keys() {
        Page page;
        QVERIFY(page.exposed());
        QTest::keyClick(&page.window, Qt::Key_W);
        QVERIFY(page.voice.said().back().startsWith("The face. "));
        QTest::keyClick(&page.window, Qt::Key_V);
        QVERIFY(!page.session.words()->voiceOn());
        QTest::keyClick(&page.window, Qt::Key_V);
        QCOMPARE(page.voice.said().back(), QString("Voice on."));
    }

    void escape_is_left_to_the_shell_where_there_is_nothing_to_stop() {
        Page page;
        QVERIFY(page.exposed());
        const auto press_escape = [&] {
            QKeyEvent press(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
            QCoreApplication::sendEvent(&page.window, &press);
            return press.isAccepted();
        };
        QVERIFY(page.session.device()->engaged());
        QVERIFY(press_escape());
        QVERIFY(!page.session.device()->engaged());
        QVERIFY(!press_escape());
        QTest::keyClick(&page.window, Qt::Key_Return);
        QVERIFY(press_escape());
    }

    void keys_zoom_tour_and_guide() {
        Page page;
        QVERIFY(page.exposed());
        QTest::keyClick(&page.window, Qt::Key_Z);
        QCOMPARE(page.voice.said().back(), QString("Zoomed to the eyes."));
        QTest::keyClick(&page.window, Qt::Key_Z);
        QCOMPARE(page.voice.said().back(), QString("Zoomed to the mouth."));
        QTest::keyClick(&page.window, Qt::Key_Z, Qt::ShiftModifier);
        QCOMPARE(page.voice.said().back(), QString("Zoomed out to the whole face."));
        QTest::keyClick(&page.window, Qt::Key_T);
        QVERIFY(page.session.tour()->touring());
        QVERIFY(page.window.named("End the tour") != nullptr);
        QTest::keyClick(&page.window, Qt::Key_T);
        QVERIFY(!page.session.tour()->touring());
        for (const char* guide : {"Ticks under the finger", "Ticks and beeps", "None"}) {
            QTest::keyClick(&page.window, Qt::Key_G);
            QVERIFY(page.voice.said().contains(QString("Guide: %1.").arg(guide)));
        }
        bool asked = false;
        connect(&page.session, &ExploreSession::backAsked, this, [&] { asked = true; });
        QTest::keyClick(&page.window, Qt::Key_Backspace);
        QVERIFY(asked);
    }

    void fingers_on_the_screen_explore_tap_and_zoom() {
        Page page;
        QVERIFY(page.exposed());
        QPointingDevice* screen = QTest::createTouchDevice();
        const auto tap = [&](int fingers, QPoint place) {
            for (int i = 0; i < fingers; ++i)
                QTest::touchEvent(&page.window, screen).press(i, place + QPoint(60 * i, 0), &page.window);
            auto up = QTest::touchEvent(&page.window, screen);
            for (int i = 0; i < fingers; ++i)
                up.release(i, place + QPoint(60 * i, 0), &page.window);
            up.commit();
        };
        const QPoint place = page.pixel(page.beside(20.0));
        QTest::touchEvent(&page.window, screen).press(0, place, &page.window);
        QVERIFY(page.sounds.guide.sounds());
        QTest::touchEvent(&page.window, screen).release(0, place, &page.window);
        QVERIFY(!page.sounds.guide.sounds());
        QTest::qWait(700); // so that the next tap is not its second
        page.voice.clear();
        tap(3, place);
        QVERIFY2(page.voice.said().value(0).startsWith("The face. "),
                 qPrintable(page.voice.said().join("|")));
        tap(2, place);
        QVERIFY(!page.session.device()->engaged());
        QTest::qWait(700);
        page.voice.clear();
        tap(1, place);
        tap(1, place);
        QVERIFY2(page.voice.said().back().startsWith("The face. "), qPrintable(page.voice.said().join("|")));
        QTest::qWait(700);
        const QPoint lips = page.pixel(
            page.session.view()->frame().from_surface(page.session.view()->felt().lines[2].points[0]));
        tap(1, lips);
        QTest::touchEvent(&page.window, screen).press(0, lips, &page.window);
        QTest::qWait(600);
        QCOMPARE(page.session.view()->featureCount(), 4); // not before the finger is lifted
        QTest::touchEvent(&page.window, screen).release(0, lips, &page.window);
        QCOMPARE(page.voice.said().back(), QString("Zoomed to the mouth."));
        QCOMPARE(page.session.view()->featureCount(), 1);
    }

    void two_fingers_or_a_key_walk_through_the_album() {
        Page page;
        QVERIFY(page.exposed());
        QPointingDevice* screen = QTest::createTouchDevice();
        const auto swipe = [&](int across) {
            page.voice.clear();
            const QPoint place = page.surface()->mapToScene({0.5 * page.surface()->width(), 100.0}).toPoint();
            const auto all = [&](auto change) {
                auto event = QTest::touchEvent(&page.window, screen);
                for (int i = 0; i < 2; ++i)
                    change(event, i, place + QPoint(0, 60 * i));
                event.commit();
            };
            all([&](auto& event, int id, QPoint at) { event.press(id, at, &page.window); });
            for (const int part : {1, 2, 3, 4})
                all([&](auto& event, int id, QPoint at) {
                    event.move(id, at + QPoint(part * across / 4, 0), &page.window);
                });
            all([&](auto& event, int id, QPoint at) {
                event.release(id, at + QPoint(across, 0), &page.window);
            });
            return page.voice.said().isEmpty() ? QString() : page.voice.said().back();
        };
        const int far = static_cast<int>(0.3 * page.surface()->width());
        const QString after = "No photograph with a face comes after this one.";
        const QString before = "No photograph with a face comes before this one.";
        QCOMPARE(swipe(far), after);
        QCOMPARE(swipe(-far), before);
        QVERIFY(!page.sounds.guide.sounds());
        page.voice.clear();
        QTest::keyClick(&page.window, Qt::Key_N);
        QCOMPARE(page.voice.said().value(0), after);
        page.voice.clear();
        QTest::keyClick(&page.window, Qt::Key_N, Qt::ShiftModifier);
        QCOMPARE(page.voice.said().value(0), before);
    }
};

} // namespace explore_keys_test

TP_TEST(explore_keys_test, ExploreKeysTest, window)
#include "explore_keys_test.moc"
