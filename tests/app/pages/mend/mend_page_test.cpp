// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_module.hpp"
#include "mend_bench.hpp"
#include "page_test.hpp"
#include "page_window.hpp"
#include "test_program.hpp"

#include <QAccessible>
#include <QImage>
#include <QPointingDevice>
#include <QQuickItem>
#include <QSet>
#include <QTest>

namespace mend_page_test {

using namespace tp;

namespace {

struct MendWindow : MendBench {
    PageWindow window;

    explicit MendWindow(QSize size = {1280, 800}, double text_scale = 1.0, int faces = 1)
        : MendBench(faces), window("Mend/MendPage.qml", &session, size) {
        window.set_text_scale(text_scale);
    }
    bool exposed() { return window.exposed(); }

    QQuickItem* surface() const { return window.rootObject()->findChild<QQuickItem*>("surface"); }
    /// A point of the contour in hand, in the window.
    QPoint pixel(int node, QPointF beside = {}) {
        return surface()->mapToScene(MendBench::window(node) + beside).toPoint();
    }
    /// Pixels of the screen that are so many of the photograph.
    Vec2 photo_px(QPoint by) { return Vec2(by.x(), by.y()) / session.view()->scale(); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(&window, key, modifiers);
    }

    QAccessibleInterface* named(const QString& name) { return window.named(name); }
    bool act(const QString& name, const QString& action = QAccessibleActionInterface::pressAction()) {
        return PageWindow::act(named(name), action);
    }
};

bool near_to(Vec2 one, Vec2 other, double within) { return length(one - other) < within; }

} // namespace

class MendPageTest : public PageTest {
    Q_OBJECT
private slots:
    void initTestCase() { register_mend(); }

    void it_shows_photograph_lines_and_points() {
        MendWindow page;
        QVERIFY(page.exposed());
        const QImage picture = page.window.grabWindow();
        QSet<QRgb> colours;
        for (int y = 0; y < picture.height(); y += 2)
            for (int x = 0; x < picture.width(); x += 2)
                colours << picture.pixel(x, y);
        QVERIFY(colours.contains(qRgb(90, 110, 130)) && colours.size() > 50);
        const QPoint corner = page.pixel(0);
        QCOMPARE(picture.pixel(corner), qRgb(255, 255, 255)); // a point, not in hand
    }
    void an_empty_page_loads_too() {
        RecordingVoice voice;
        RecordingAnnouncer announcer;
        Narrator narrator(voice, announcer);
        MendSession session(narrator);
        PageWindow window("Mend/MendPage.qml", &session);
        QVERIFY(window.exposed());
    }

    void the_mouse_drags_a_point() {
        MendWindow page;
        QVERIFY(page.exposed());
        const Vec2 before = page.node(0).at;
        const QPoint from = page.pixel(0, {4, 3});
        const QPoint by(-60, 25);
        QTest::mousePress(&page.window, Qt::LeftButton, {}, from);
        for (int i = 1; i <= 10; ++i)
            QTest::mouseMove(&page.window, from + by * i / 10);
        QTest::mouseRelease(&page.window, Qt::LeftButton, {}, from + by);
        QVERIFY(near_to(page.node(0).at, before + page.photo_px(by), 1e-6));
        QVERIFY(page.said().startsWith("Corner 1 of "));
        page.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(page.node(0).at == before);
        page.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(!(page.node(0).at == before));
    }
    void a_finger_drags_a_point() {
        MendWindow page;
        QVERIFY(page.exposed());
        const Vec2 before = page.node(0).at;
        const QPoint from = page.pixel(0, {-20, 8}); // within 24 px
        const QPoint by(-50, -40);
        QPointingDevice* screen = QTest::createTouchDevice();
        QTest::touchEvent(&page.window, screen).press(0, from, &page.window);
        for (int i = 1; i <= 10; ++i)
            QTest::touchEvent(&page.window, screen).move(0, from + by * i / 10, &page.window);
        QTest::touchEvent(&page.window, screen).release(0, from + by, &page.window);
        QVERIFY(near_to(page.node(0).at, before + page.photo_px(by), 1e-6));
    }
    void a_finger_that_trembles_moves_nothing() {
        MendWindow page;
        QVERIFY(page.exposed());
        const std::string before = page.text();
        QPointingDevice* screen = QTest::createTouchDevice();
        const QPoint at = page.pixel(2);
        QTest::touchEvent(&page.window, screen).press(0, at, &page.window);
        QTest::touchEvent(&page.window, screen).move(0, at + QPoint(2, 1), &page.window);
        QTest::touchEvent(&page.window, screen).release(0, at + QPoint(2, 1), &page.window);
        QCOMPARE(page.text(), before);
        QCOMPARE(page.selection().handle(), 2);
        QVERIFY(page.said().startsWith(page.selection().handleName()));
    }
    void escape_puts_back_what_is_dragged_and_is_left_alone_otherwise() {
        MendWindow page;
        QVERIFY(page.exposed());
        const std::string before = page.text();
        const QPoint from = page.pixel(0);
        QTest::mousePress(&page.window, Qt::LeftButton, {}, from);
        QTest::mouseMove(&page.window, from + QPoint(30, 30));
        QTest::mouseMove(&page.window, from + QPoint(40, 30));
        QVERIFY(page.text() != before);
        page.key(Qt::Key_Escape);
        QCOMPARE(page.text(), before);
        QTest::mouseMove(&page.window, from + QPoint(80, 30));
        QTest::mouseRelease(&page.window, Qt::LeftButton, {}, from + QPoint(80, 30));
        QCOMPARE(page.text(), before);
    }
    void beside_a_point_the_photograph_moves_under_the_hand() {
        MendWindow page;
        QVERIFY(page.exposed());
        const std::string before = page.text();
        const QPointF origin = page.session.view()->origin();
        const QPoint from = page.surface()->mapToScene({30, page.surface()->height() - 30}).toPoint();
        QTest::mousePress(&page.window, Qt::LeftButton, {}, from);
        for (int i = 1; i <= 5; ++i)
            QTest::mouseMove(&page.window, from + QPoint(10 * i, -8 * i));
        QTest::mouseRelease(&page.window, Qt::LeftButton, {}, from + QPoint(50, -40));
        QCOMPARE(page.text(), before);
        QVERIFY(page.session.view()->origin().x() < origin.x() &&
                page.session.view()->origin().y() > origin.y());
    }

    void everything_by_keys_alone() {
        MendWindow page;
        QVERIFY(page.exposed());
        QVERIFY(page.surface()->hasActiveFocus());
        page.key(Qt::Key_Tab);
        QVERIFY(page.said().startsWith("Corner 1 of "));
        const Vec2 before = page.node(0).at;
        page.key(Qt::Key_Right);
        page.key(Qt::Key_Down, Qt::ShiftModifier);
        page.key(Qt::Key_Left, Qt::ControlModifier);
        QVERIFY(near_to(page.node(0).at, before + Vec2(0.8, 10.0), 1e-9));
        QVERIFY(page.said().endsWith("130 down."));
        const int count = page.selection().handles()->rowCount();
        page.key(Qt::Key_A);
        QCOMPARE(page.selection().handles()->rowCount(), count + 2);
        page.key(Qt::Key_Delete);
        QCOMPARE(page.selection().handles()->rowCount(), count);
        page.key(Qt::Key_M);
        QVERIFY(page.selection().wholeFeature());
        page.key(Qt::Key_Up);
        page.key(Qt::Key_M);
        page.key(Qt::Key_PageDown);
        QCOMPARE(page.selection().featureName(), QString("right eye"));
        page.key(Qt::Key_Tab);
        page.key(Qt::Key_C);
        QCOMPARE(page.said(), QString("Smooth now."));
        const double scale = page.session.view()->scale();
        page.key(Qt::Key_Plus);
        QVERIFY(page.session.view()->scale() > scale);
        page.key(Qt::Key_F);
        QVERIFY(page.session.preview()->forceShown());
        page.key(Qt::Key_W);
        QVERIFY(page.said().contains("of the right eye"));
        QVERIFY(page.session.file()->unsaved());
        page.key(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(!page.session.file()->unsaved());
        QCOMPARE(page.bytes(), page.text());
    }
    void the_keyboard_is_not_kept() {
        MendWindow page;
        QVERIFY(page.exposed());
        for (int i = 0; i <= page.selection().handles()->rowCount(); ++i)
            page.key(Qt::Key_Tab);
        QVERIFY(!page.surface()->hasActiveFocus());
        page.key(Qt::Key_Backtab, Qt::ShiftModifier);
        QVERIFY(page.surface()->hasActiveFocus());
    }
    void what_the_keyboard_comes_to_is_in_view() {
        MendWindow page({600, 700}, 2.0);
        QVERIFY(page.exposed());
        page.selection().chooseHandle(page.selection().handles()->rowCount() - 1);
        for (int i = 0; i < 25; ++i) {
            page.key(Qt::Key_Tab);
            const QQuickItem* focused = page.window.activeFocusItem();
            const QRectF place = focused->mapRectToScene(focused->boundingRect());
            QVERIFY2(place.top() >= -1.0 && place.bottom() <= page.window.height() + 1.0,
                     qPrintable(QString("%1: %2 to %3").arg(i).arg(place.top()).arg(place.bottom())));
        }
    }

    void everything_by_a_screen_reader_alone() {
        MendWindow page;
        QVERIFY(page.exposed());
        const int count = page.selection().handles()->rowCount();
        const QString corner = QString("Corner 1 of %1").arg(count);
        QVERIFY(page.act(corner));
        QCOMPARE(page.selection().handle(), 0);
        const Vec2 before = page.node(0).at;
        for (const auto& action :
             {QAccessibleActionInterface::scrollLeftAction(), QAccessibleActionInterface::scrollLeftAction(),
              QAccessibleActionInterface::scrollRightAction(), QAccessibleActionInterface::scrollUpAction(),
              QAccessibleActionInterface::scrollDownAction(), QAccessibleActionInterface::scrollDownAction()})
            QVERIFY2(page.act(corner, action), qPrintable(action));
        QVERIFY(near_to(page.node(0).at, before + Vec2(-1, 1), 1e-9));
        QVERIFY(page.act(corner, QAccessibleActionInterface::nextPageAction()));
        QCOMPARE(page.selection().handle(), 1);
        QVERIFY(page.act(corner, QAccessibleActionInterface::previousPageAction()));
        QCOMPARE(page.selection().handle(), 0);
        for (const char* name : {"Move left", "Move right", "Move up", "Move up"})
            QVERIFY2(page.act(name), name);
        QVERIFY(near_to(page.node(0).at, before + Vec2(-1, -1), 1e-9));
        for (const char* name :
             {"Next point", "Previous point", "Add a point", "Delete the point", "Zoom in", "Zoom out",
              "Whole photograph", "This feature", "Undo", "Redo", "Feature: right eye"})
            QVERIFY2(page.act(name), name);
        QCOMPARE(page.selection().featureName(), QString("right eye"));
        for (const char* name : {"Move the whole feature", "Show the force"})
            QVERIFY2(page.act(name, QAccessibleActionInterface::toggleAction()), name);
        QVERIFY(page.selection().wholeFeature() && page.session.preview()->forceShown());
        QVERIFY(page.act("Remove the feature"));
        QVERIFY(!page.selection().featureThere());
        QVERIFY(page.act("Add the right eye"));
        QVERIFY(page.selection().featureThere());
        QVERIFY(page.act("Save"));
        QCOMPARE(page.bytes(), page.text());
        QVERIFY(page.act("Discard all changes"));
        QVERIFY(page.act("Save"));
        QVERIFY(page.bytes().empty());
    }
    void what_can_be_operated_has_a_name_and_is_large_enough() {
        MendWindow page;
        QVERIFY(page.exposed());
        int operable = 0;
        for (QAccessibleInterface* one : PageWindow::everything(page.window)) {
            const QStringList actions =
                one->actionInterface() != nullptr ? one->actionInterface()->actionNames() : QStringList();
            if ((!one->state().focusable && !actions.contains(QAccessibleActionInterface::pressAction())) ||
                one->role() == QAccessible::Window || one->role() == QAccessible::Client ||
                one->role() == QAccessible::StaticText) // Qt calls every text focusable
                continue;
            ++operable;
            const QString name = one->text(QAccessible::Name);
            QVERIFY2(!name.isEmpty(), qPrintable(QString("role %1").arg(one->role())));
            QVERIFY2(one->rect().width() >= 48 && one->rect().height() >= 48,
                     qPrintable(QString("%1: %2 × %3, %4")
                                    .arg(name)
                                    .arg(one->rect().width())
                                    .arg(one->rect().height())
                                    .arg(actions.join(' '))));
        }
        QVERIFY(operable >= 40);
    }
    void it_fits_every_window() {
        for (const QSize size : {QSize(1280, 800), QSize(600, 1000), QSize(480, 560), QSize(560, 480)})
            for (const double scale : {1.0, 2.0}) {
                MendWindow page(size, scale);
                QVERIFY(page.exposed());
                const QRectF place = page.surface()->mapRectToScene(page.surface()->boundingRect());
                QVERIFY2(place.width() >= 180 && place.height() >= 180,
                         qPrintable(QString("%1×%2 at %3").arg(size.width()).arg(size.height()).arg(scale)));
                QVERIFY(page.window.rootObject()->boundingRect().contains(place));
                QVERIFY(!page.window.grabWindow().isNull());
            }
    }
};

} // namespace mend_page_test

TP_TEST(mend_page_test, MendPageTest, window)
#include "mend_page_test.moc"
