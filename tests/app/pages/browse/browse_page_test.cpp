// SPDX-License-Identifier: Apache-2.0
#include "browse_page.hpp"
#include "page_test.hpp"
#include "test_program.hpp"

#include <QAccessible>
#include <QColor>
#include <QCoreApplication>
#include <QQuickItem>
#include <QRectF>
#include <QSet>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>

namespace browse_page_test {

using namespace tp;
using namespace tp::testing;
using View = BrowseTrail::View;

class BrowsePageTest : public PageTest {
    Q_OBJECT
private slots:
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

} // namespace browse_page_test

TP_TEST(browse_page_test, BrowsePageTest, window)
#include "browse_page_test.moc"
