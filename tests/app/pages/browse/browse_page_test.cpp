// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/browse_module.hpp"
#include "browse_bench.hpp"
#include "page_window.hpp"

#include <QAccessible>
#include <QColor>
#include <QCoreApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QPointingDevice>
#include <QQmlComponent>
#include <QQuickItem>
#include <QQuickView>
#include <QRectF>
#include <QSet>
#include <QSignalSpy>
#include <QTest>
#include <QUrl>
#include <QVariant>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

using namespace tp;
using namespace tp::testing;
using View = BrowseTrail::View;

namespace {

const QString garden_words = "Anna and Tom, May 2026, Vienna; 2 recording(s).";

/// One for all tests: Qt keeps what it knows of a device for as long as the program runs.
QPointingDevice* touch_screen() {
    static QPointingDevice* const screen = QTest::createTouchDevice();
    return screen;
}

/// The page in a window, at the garden.
struct Page : BrowseBench {
    DrawnAlbum::Five five;
    QQuickView window;
    QPointingDevice* screen = touch_screen();

    explicit Page(QSize size = {1280, 800}, bool empty = false) {
        if (!empty)
            five = drawn.five();
        start();
        if (!empty)
            go_to(five.garden);
        register_browse();
        window.setResizeMode(QQuickView::SizeRootObjectToView);
        window.resize(size);
        window.setInitialProperties({{"session", QVariant::fromValue(session.get())}});
        window.setSource(QUrl("qrc:/qt-project.org/imports/TouchPhoto/Browse/BrowsePage.qml"));
        window.show();
        window.requestActivate();
    }
    bool ready() {
        return window.status() == QQuickView::Ready && QTest::qWaitForWindowExposed(&window) &&
               window.rootObject() != nullptr;
    }
    QQuickItem* item(const char* name) const { return window.rootObject()->findChild<QQuickItem*>(name); }
    QPoint middle() const {
        QQuickItem* pane = item("pane");
        return pane->mapToScene({0.5 * pane->width(), 0.5 * pane->height()}).toPoint();
    }
    void key(Qt::Key key) { QTest::keyClick(&window, key); }
    void words(const char* text) {
        for (const char* letter = text; *letter != '\0'; ++letter)
            QTest::keyClick(&window, *letter);
    }

    /// Fingers side by side along a way, and up.
    void draw(const QList<QPoint>& way, int fingers = 1) {
        const auto at = [](const QPoint& place, int finger) { return place + QPoint(0, 90 * finger); };
        {
            auto event = QTest::touchEvent(&window, screen);
            for (int finger = 0; finger < fingers; ++finger)
                event.press(finger, at(way.front(), finger), &window);
        }
        for (int i = 1; i < way.size(); ++i) {
            for (int step = 1; step <= 5; ++step) {
                auto event = QTest::touchEvent(&window, screen);
                for (int finger = 0; finger < fingers; ++finger)
                    event.move(finger, at(way[i - 1] + (way[i] - way[i - 1]) * step / 5, finger), &window);
            }
            QSignalSpy drawn(&window, &QQuickWindow::afterAnimating); // movements come once a frame
            window.update();
            if (!drawn.wait())
                qFatal("no frame is drawn");
        }
        auto event = QTest::touchEvent(&window, screen);
        for (int finger = 0; finger < fingers; ++finger)
            event.release(finger, at(way.back(), finger), &window);
    }
    void swipe(int dx, int dy) { draw({middle(), middle() + QPoint(dx, dy)}); }
    void tap(int fingers = 1) { draw({middle()}, fingers); }
    void theme(const char* name, const QVariant& value) {
        QQmlComponent component(window.engine());
        component.setData(
            "import QtQml\nimport TouchPhoto.Controls\nQtObject { readonly property var theme: Theme }",
            QUrl());
        const std::unique_ptr<QObject> holder(component.create());
        QVERIFY2(holder != nullptr, qPrintable(component.errorString()));
        holder->property("theme").value<QObject*>()->setProperty(name, value);
        window.grabWindow(); // everything is laid out anew
    }
};

bool act(QQuickWindow& window, const QString& name,
         const QString& action = QAccessibleActionInterface::pressAction()) {
    return PageWindow::act(PageWindow::named(window, name), action);
}

} // namespace

class BrowsePageTest : public QObject {
    Q_OBJECT
    std::optional<Warnings> warnings_;

private slots:
    void initTestCase() { QAccessible::setActive(true); }
    void init() { warnings_.emplace(); }
    void cleanup() { QCOMPARE(Warnings::all(), QStringList()); } // QML's above all

    void it_shows_the_photograph_and_its_words() {
        Page page;
        QVERIFY(page.ready());
        QTRY_VERIFY(!page.session->details()->picture().isNull());
        QVERIFY(PageWindow::named(page.window, garden_words) != nullptr);
        QVERIFY(PageWindow::named(page.window, garden_words + " 4 of 5") != nullptr);
        QVERIFY(PageWindow::named(page.window, "Photograph: 4 of 5") != nullptr);
        const QColor colour = page.window.grabWindow().pixelColor(page.middle());
        QVERIFY2(colour.saturation() > 60, qPrintable(colour.name())); // the picture, not the ground
    }

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

    void a_screen_reader_does_all_of_it() {
        Page page;
        QVERIFY(page.ready());
        const QString photo = garden_words + " 4 of 5";
        QAccessibleInterface* pane = PageWindow::named(page.window, photo);
        QVERIFY(pane != nullptr);
        QCOMPARE(pane->role(), QAccessible::Graphic);
        QVERIFY(pane->state().focusable);
        QVERIFY(act(page.window, photo, QAccessibleActionInterface::increaseAction()));
        QCOMPARE(page.said(), QString("Anna"));
        QVERIFY(act(page.window, photo, QAccessibleActionInterface::decreaseAction()));
        QVERIFY(act(page.window, photo));
        QVERIFY(page.session->playback()->playing());
        QVERIFY(act(page.window, "Pause"));
        QVERIFY(act(page.window, photo, QAccessibleActionInterface::nextPageAction()));
        QCOMPARE(page.session->trail()->position(), 5);
        QVERIFY(act(page.window, page.session->details()->summary() + " 5 of 5",
                    QAccessibleActionInterface::previousPageAction()));
        QCOMPARE(page.session->trail()->position(), 4);
        QVERIFY(act(page.window, "Next"));
        QVERIFY(act(page.window, "Previous"));
        QCOMPARE(page.session->trail()->position(), 4);
        QVERIFY(act(page.window, "Next detail"));
        QVERIFY(act(page.window, "Previous detail"));
        QVERIFY(act(page.window, "People"));
        QVERIFY(act(page.window, "Ben, 1 photograph(s), 2 of 3"));
        QCOMPARE(page.session->trail()->title(), QString("Ben"));
        QVERIFY(act(page.window, "Back"));
        QVERIFY(act(page.window, "Back"));
        QVERIFY(act(page.window, "Search"));
        QVERIFY(PageWindow::named(page.window, "A name, a place or any word") != nullptr);
        QVERIFY(act(page.window, "Back"));
        QVERIFY(act(page.window, "Surprise me"));
        QVERIFY(act(page.window, "Faster"));
        QVERIFY(act(page.window, "Slower"));
        QVERIFY(act(page.window, "Where am I?"));
        QCOMPARE(page.window.rootObject()->property("help").toString(), page.session->keys());
        QSignalSpy explore(page.session.get(), &BrowseSession::exploreAsked),
            care(page.session.get(), &BrowseSession::careAsked);
        QVERIFY(act(page.window, "Feel the face"));
        QVERIFY(act(page.window, "Look after it"));
        QCOMPARE(explore.count() + care.count(), 2);
    }

    void an_empty_album_offers_what_to_do() {
        Page page({1280, 800}, true);
        QVERIFY(page.ready());
        QSignalSpy settings(page.session.get(), &BrowseSession::settingsAsked),
            import(page.session.get(), &BrowseSession::importAsked);
        QVERIFY(PageWindow::named(page.window, page.session->album()->emptyText()) != nullptr);
        QVERIFY(act(page.window, "Choose folders"));
        QVERIFY(act(page.window, "Import photographs"));
        QCOMPARE(settings.count(), 1);
        QCOMPARE(import.count(), 1);
        QVERIFY(PageWindow::named(page.window, "Next") == nullptr);
    }

    void everything_operable_has_name_and_size_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<double>("scale");
        QTest::newRow("wide") << QSize(1280, 800) << 1.0;
        QTest::newRow("wide, large text") << QSize(1280, 800) << 2.0;
        QTest::newRow("tall") << QSize(600, 1000) << 1.0;
        QTest::newRow("tall, large text") << QSize(600, 1000) << 2.0;
        QTest::newRow("smallest") << QSize(480, 560) << 2.0;
    }
    void everything_operable_has_name_and_size() {
        QFETCH(QSize, size);
        QFETCH(double, scale);
        Page page(size);
        QVERIFY(page.ready());
        page.theme("textScale", scale);
        for (const auto& view : {View::Photos, View::Names, View::Search}) {
            if (view == View::Names)
                page.session->lists()->openTopic(BrowseLists::Topic::People);
            if (view == View::Search)
                page.session->lists()->openSearch();
            QCoreApplication::processEvents();
            int operable = 0;
            for (QAccessibleInterface* one : PageWindow::everything(page.window)) {
                auto* item = qobject_cast<QQuickItem*>(one->object());
                const bool control =
                    one->role() == QAccessible::Button || one->role() == QAccessible::Graphic ||
                    one->role() == QAccessible::ListItem || one->role() == QAccessible::EditableText;
                if (item == nullptr || !control)
                    continue;
                QVERIFY(one->state().focusable);
                ++operable;
                QVERIFY2(!one->text(QAccessible::Name).isEmpty(), qPrintable(QString::number(one->role())));
                QVERIFY2(item->width() >= 64.0 && item->height() >= 64.0,
                         qPrintable(one->text(QAccessible::Name)));
                QVERIFY2(item->mapRectToScene(item->boundingRect()).left() >= 0.0,
                         qPrintable(one->text(QAccessible::Name)));
                QVERIFY2(item->mapRectToScene(item->boundingRect()).right() <= size.width(),
                         qPrintable(one->text(QAccessible::Name)));
            }
            QVERIFY(operable >= (view == View::Photos ? 14 : view == View::Names ? 4 : 2));
        }
    }

    void tab_goes_in_the_order_of_reading() {
        Page page;
        QVERIFY(page.ready());
        const auto once_round = [&] {
            QStringList order = PageWindow::tab_order(page.window);
            const QString first = PageWindow::reading_order(page.window).value(0);
            std::rotate(order.begin(), order.begin() + order.indexOf(first), order.end());
            return order;
        };
        QCOMPARE(once_round(), PageWindow::reading_order(page.window));
        page.session->lists()->openTopic(BrowseLists::Topic::People);
        QCOMPARE(once_round(), PageWindow::reading_order(page.window));
        page.session->lists()->openSearch();
        page.session->lists()->type("an");
        QCOMPARE(once_round(), PageWindow::reading_order(page.window));
    }

    void what_the_keyboard_comes_to_is_in_view_and_nothing_traps_it() {
        for (const QSize size : {QSize(1280, 800), QSize(480, 560)}) {
            Page page(size);
            QVERIFY(page.ready());
            page.theme("textScale", 2.0);
            QSet<QQuickItem*> visited;
            for (int i = 0; i < 30; ++i) {
                page.key(Qt::Key_Tab);
                QQuickItem* focused = page.window.activeFocusItem();
                visited << focused;
                const QRectF place = focused->mapRectToScene(focused->boundingRect());
                QVERIFY2(place.top() >= -1.0 && place.bottom() <= size.height() + 1.0,
                         qPrintable(QString("%1 at %2 to %3")
                                        .arg(focused->metaObject()->className())
                                        .arg(place.top())
                                        .arg(place.bottom())));
            }
            QVERIFY(visited.contains(page.item("pane")));
            QVERIFY(visited.size() >= 14);
        }
    }
};

QTEST_MAIN(BrowsePageTest)
#include "browse_page_test.moc"
