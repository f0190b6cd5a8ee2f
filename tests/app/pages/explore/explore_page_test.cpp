// SPDX-License-Identifier: Apache-2.0
#include "explore_page.hpp"
#include "page_test.hpp"
#include "test_program.hpp"

#include <QAccessible>
#include <QCoreApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QImage>
#include <QMimeData>
#include <QPointingDevice>
#include <QQuickItem>
#include <QRectF>
#include <QSet>
#include <QTest>
#include <QUrl>

namespace explore_page_test {

using namespace tp;

class ExplorePageTest : public PageTest {
    Q_OBJECT
private slots:
    void initTestCase() { register_explore(); }

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
};

} // namespace explore_page_test

TP_TEST(explore_page_test, ExplorePageTest, window)
#include "explore_page_test.moc"
