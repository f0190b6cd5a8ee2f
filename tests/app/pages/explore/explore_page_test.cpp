// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_module.hpp"
#include "app/parts/controls/notification_announcer.hpp"
#include "explore_bench.hpp"
#include "page_window.hpp"

#include <QAccessible>
#include <QCoreApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QKeyEvent>
#include <QLineF>
#include <QMimeData>
#include <QPointingDevice>
#include <QQuickItem>
#include <QSet>
#include <QTest>
#include <QUrl>
#include <QtGlobal>

#include <optional>

using namespace tp;

namespace {

struct Page {
    RecordingVoice voice;
    NotificationAnnouncer announcer;
    Narrator narrator{voice, announcer};
    ExploreSounds sounds;
    ExploreSession session{narrator, sounds.earcons, sounds.guide, sounds.preferences, patient_settings()};
    PageWindow window{"Explore/ExplorePage.qml", &session};

    Page() { session.show(drawn_photo()); }
    bool exposed() { return window.exposed(); }

    QQuickItem* surface() const { return window.rootObject()->findChild<QQuickItem*>("surface"); }
    /// Sheet frame → window.
    QPoint pixel(QPointF place) const {
        const double scale = surface()->width() / session.view()->surfaceWidth();
        return surface()->mapToScene(scale * place).toPoint();
    }
    /// A place 5 mm inside of the outline's left side, and one higher up.
    QPointF beside(double higher = 0.0) const {
        const QPointF corner =
            session.view()->frame().from_surface(session.view()->felt().lines[outline].points[1]);
        return corner + QPointF(5.0, -30.0 - higher);
    }
    static constexpr int left_eye = 0;
    static constexpr int outline = 3;
};

} // namespace

class ExplorePageTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QAccessible::setActive(true);
        register_explore();
    }
    void init() { warnings_.emplace(); }
    void cleanup() { QCOMPARE(Warnings::all(), QStringList()); } // QML's above all

    void it_loads_and_shows_the_photograph_and_the_lines() {
        Page page;
        QVERIFY(page.exposed());
        const QImage picture = page.window.grabWindow();
        QSet<QRgb> colours;
        for (int y = 0; y < picture.height(); y += 3)
            for (int x = 0; x < picture.width(); x += 3)
                colours << picture.pixel(x, y);
        QVERIFY(colours.size() > 50);
    }

    void an_empty_page_loads_too() {
        RecordingVoice voice;
        NotificationAnnouncer announcer;
        Narrator narrator(voice, announcer);
        ExploreSounds sounds;
        ExploreSession session(narrator, sounds.earcons, sounds.guide, sounds.preferences, patient_settings());
        PageWindow window("Explore/ExplorePage.qml", &session);
        QVERIFY(window.exposed());
        QVERIFY(window.named("No photograph yet. Press O, or drop one here.") != nullptr);
    }

    void it_loads_on_a_tall_window() {
        Page page;
        page.window.resize(600, 1000);
        QVERIFY(page.exposed());
        QTRY_VERIFY(page.surface()->width() > 400.0);
        QVERIFY(!page.window.grabWindow().isNull());
    }

    void what_the_keyboard_comes_to_is_in_view() {
        Page page;
        page.window.resize(600, 700);
        QVERIFY(page.exposed());
        for (int i = 0; i < 30; ++i) {
            QTest::keyClick(&page.window, Qt::Key_Tab);
            const QQuickItem* focused = page.window.activeFocusItem();
            const QRectF place = focused->mapRectToScene(focused->boundingRect());
            QVERIFY2(place.top() >= -1.0 && place.bottom() <= page.window.height() + 1.0,
                     qPrintable(focused->objectName()));
        }
    }

    void on_a_small_window_with_large_text_everything_can_be_reached_and_felt() {
        Page page;
        page.window.resize(480, 560);
        page.window.set_text_scale(2.0);
        QVERIFY(page.exposed());
        QTRY_VERIFY(page.surface()->hasActiveFocus());
        QTRY_VERIFY(page.surface()->width() > 350.0);
        QSet<const QQuickItem*> met;
        for (int i = 0; i < 30; ++i) {
            QTest::keyClick(&page.window, Qt::Key_Tab);
            const QQuickItem* focused = page.window.activeFocusItem();
            met << focused;
            const QRectF place = focused->mapRectToScene(focused->boundingRect());
            QVERIFY(place.top() >= -1.0 && place.bottom() <= page.window.height() + 1.0);
            QVERIFY(place.left() >= -1.0 && place.right() <= page.window.width() + 1.0);
        }
        QVERIFY(met.size() >= 14);
        while (!page.surface()->hasActiveFocus())
            QTest::keyClick(&page.window, Qt::Key_Tab);
        QPointingDevice* screen = QTest::createTouchDevice();
        const double top = page.surface()->mapToScene({}).y();
        const QPoint high = page.pixel(page.beside(40.0));
        QTest::touchEvent(&page.window, screen).press(0, high, &page.window);
        for (int i = 1; i < 20; ++i)
            QTest::touchEvent(&page.window, screen).move(0, high + QPoint(0, 5 * i), &page.window);
        QCOMPARE(page.surface()->mapToScene({}).y(), top); // it explored, and did not scroll
        QTRY_VERIFY(page.session.finger()->pointer().y() > page.beside(40.0).y() + 10.0);
        QTest::touchEvent(&page.window, screen).release(0, high, &page.window);
    }

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

    void the_feature_under_the_finger_is_spoken_and_shown() {
        Page page;
        QVERIFY(page.exposed());
        page.voice.clear();
        const QPointF on = page.session.view()->frame().from_surface(
            page.session.view()->felt().lines[Page::left_eye].points[0]);
        QTest::mouseMove(&page.window, page.pixel(on + QPointF(0.0, -12.0)));
        QTest::mouseMove(&page.window, page.pixel(on));
        QTRY_COMPARE(page.voice.said(), QStringList("left eye"));
        QVERIFY(page.window.named("Under the finger: left eye") != nullptr);
    }

    void arrow_keys_move_the_hand() {
        Page page;
        QVERIFY(page.exposed());
        const QPointF before = page.session.finger()->pointer();
        QTest::keyClick(&page.window, Qt::Key_Right);
        QTest::keyClick(&page.window, Qt::Key_Down, Qt::ShiftModifier);
        QTRY_VERIFY(QLineF(page.session.finger()->pointer(), before + QPointF(2.0, 10.0)).length() < 1e-9);
    }

    void tab_goes_through_the_features_then_the_buttons_and_back() {
        Page page;
        QVERIFY(page.exposed());
        page.voice.clear();
        for (int i = 0; i < 4; ++i)
            QTest::keyClick(&page.window, Qt::Key_Tab);
        QCOMPARE(page.voice.said(), QStringList({"left eye", "right eye", "lips", "face outline"}));
        QVERIFY(page.surface()->hasActiveFocus());
        QTest::keyClick(&page.window, Qt::Key_Tab);
        QVERIFY(!page.surface()->hasActiveFocus());
        QTest::keyClick(&page.window, Qt::Key_Backtab, Qt::ShiftModifier);
        QVERIFY(page.surface()->hasActiveFocus());
        QTest::keyClick(&page.window, Qt::Key_Backtab, Qt::ShiftModifier);
        QCOMPARE(page.voice.said().back(), QString("face outline"));
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
        QVERIFY2(page.voice.said().value(0).startsWith("The face. "), qPrintable(page.voice.said().join("|")));
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

    void a_screen_reader_zooms_and_chooses_a_guide() {
        Page page;
        QVERIFY(page.exposed());
        QAccessibleActionInterface* surface = page.window.named("Touch surface")->actionInterface();
        QVERIFY(surface->actionNames().contains(QAccessibleActionInterface::increaseAction()));
        surface->doAction(QAccessibleActionInterface::increaseAction());
        QCOMPARE(page.voice.said().back(), QString("Zoomed to the eyes."));
        surface->doAction(QAccessibleActionInterface::decreaseAction());
        QCOMPARE(page.voice.said().back(), QString("Zoomed out to the whole face."));
        surface->doAction(QAccessibleActionInterface::pressAction());
        QVERIFY(page.voice.said().back().startsWith("The face. "));
        QVERIFY(page.window.press("Zoom in"));
        QCOMPARE(page.voice.said().back(), QString("Zoomed to the eyes."));
        QVERIFY(page.window.press("Guide: Beeps"));
        QCOMPARE(page.sounds.preferences.choices().guide, Choices::Guide::sonar);
        QVERIFY(page.window.named("Guide: Beeps")->state().checked);
        QVERIFY(page.window.press("Tour of the face"));
        QVERIFY(page.session.tour()->touring());
    }

    void people_are_named_where_they_are() {
        Page page;
        page.session.show(drawn_photo(2, {"Anna", "Tom"}));
        QVERIFY(page.exposed());
        QVERIFY(page.window.named("Anna and Tom") != nullptr);
        QAccessibleInterface* eye = page.window.named("left eye of Tom");
        QVERIFY(eye != nullptr);
        QCOMPARE(eye->parent()->text(QAccessible::Name), QString("Tom"));
        QVERIFY(page.window.press("Tom"));
        QCOMPARE(page.voice.said().back(), QString("Zoomed to Tom."));
    }

    void everything_that_can_be_operated_has_a_name() {
        Page page;
        QVERIFY(page.exposed());
        int operable = 0;
        for (QAccessibleInterface* one : PageWindow::everything(page.window)) {
            const QStringList actions =
                one->actionInterface() != nullptr ? one->actionInterface()->actionNames() : QStringList();
            const bool counts =
                one->state().focusable || actions.contains(QAccessibleActionInterface::pressAction());
            if (!counts || one->role() == QAccessible::Window || one->role() == QAccessible::Client)
                continue;
            ++operable;
            QVERIFY2(
                !one->text(QAccessible::Name).isEmpty(),
                qPrintable(
                    QString("role %1 at %2,%3").arg(one->role()).arg(one->rect().x()).arg(one->rect().y())));
        }
        QVERIFY(operable >= 11);
        for (const char* name : {"Guided tour",
                                 "Tour of the face",
                                 "Where am I?",
                                 "Stop",
                                 "Zoom in",
                                 "Zoom out",
                                 "Next feature",
                                 "Strongest force",
                                 "Guide: None",
                                 "Guide: Beeps",
                                 "Guide: Clock directions",
                                 "Guide: Beeps and clock directions",
                                 "Guide: Ticks under the finger",
                                 "Guide: Ticks and beeps",
                                 "Voice",
                                 "Open photograph…",
                                 "Touch surface",
                                 "face",
                                 "left eye",
                                 "right eye",
                                 "lips",
                                 "face outline",
                                 "drawn.png"})
            QVERIFY2(page.window.named(name) != nullptr, name);
    }

    void a_screen_reader_presses_features_and_buttons() {
        Page page;
        QVERIFY(page.exposed());
        QVERIFY(page.window.press("lips"));
        QCOMPARE(page.voice.said().back(), QString("lips"));
        QVERIFY(page.window.press("Guided tour"));
        QVERIFY(page.session.tour()->touring());
        QVERIFY(page.window.named("End the tour") != nullptr);
        QVERIFY(page.window.press("Stop"));
        QVERIFY(!page.session.tour()->touring());
        QVERIFY(page.window.named("Force on") != nullptr);
    }

    void with_the_voice_off_a_screen_reader_is_told() {
        Page page;
        QVERIFY(page.exposed());
        page.session.words()->setVoiceOn(false);
        page.session.hand()->goToFeature(Page::left_eye);
        QCOMPARE(page.announcer.sentence(), QString("left eye"));
        QTRY_VERIFY(page.announcer.shown());
    }

    void a_photograph_dropped_on_the_page_is_opened() {
        Page page;
        QVERIFY(page.exposed());
        QMimeData mime;
        mime.setUrls({QUrl::fromLocalFile("/nowhere/dropped.jpg")});
        const QPointF middle(page.window.width() / 2.0, page.window.height() / 2.0);
        QDragEnterEvent enter(middle.toPoint(), Qt::CopyAction, &mime, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&page.window, &enter);
        QDropEvent drop(middle, Qt::CopyAction, &mime, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&page.window, &drop);
        QTRY_COMPARE_WITH_TIMEOUT(page.session.view()->state(), ExploreView::State::Problem, 30000);
        QVERIFY(page.session.words()->sentence().contains("dropped.jpg"));
    }

private:
    std::optional<Warnings> warnings_;
};

QTEST_MAIN(ExplorePageTest)
#include "explore_page_test.moc"
