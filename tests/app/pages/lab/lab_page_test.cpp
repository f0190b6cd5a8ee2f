// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_module.hpp"
#include "lab_bench.hpp"
#include "page_test.hpp"
#include "page_window.hpp"
#include "test_program.hpp"

#include <QDir>
#include <QPointingDevice>
#include <QQmlComponent>
#include <QQmlEngine>

#include <memory>

namespace lab_page_test {

using namespace tp;

class LabPageTest : public PageTest {
    Q_OBJECT
private slots:
    void initTestCase() { register_lab(); }

    void everything_has_a_name_and_size_and_tab_goes_round_in_reading_order_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<double>("scale");
        QTest::newRow("wide") << QSize(1280, 800) << 1.0;
        QTest::newRow("wide, large text") << QSize(1280, 800) << 2.0;
        QTest::newRow("tall") << QSize(600, 1000) << 1.0;
        QTest::newRow("tall, large text") << QSize(600, 1000) << 2.0;
        QTest::newRow("smallest") << QSize(480, 560) << 1.0;
        QTest::newRow("smallest, large text") << QSize(480, 560) << 2.0;
    }
    void everything_has_a_name_and_size_and_tab_goes_round_in_reading_order() {
        QFETCH(QSize, size);
        QFETCH(double, scale);
        LabBench bench;
        PageWindow window(page, &bench.session, size);
        QVERIFY(window.exposed());
        enlarge_text(window, scale);
        QTRY_VERIFY(!bench.session.scene()->field().isNull());
        QCOMPARE(window.faulty_targets().join("; "), QString());
        const QStringList tabbed = PageWindow::tab_order(window);
        QCOMPARE(tabbed, PageWindow::reading_order(window));
        QVERIFY(tabbed.size() > 25);
    }

    void keys_alone_start_move_and_stop() {
        LabBench bench;
        PageWindow window(page, &bench.session);
        QVERIFY(window.exposed());
        QTest::keyClick(&window, Qt::Key_Space);
        QCOMPARE(bench.session.activity()->state(), LabActivity::Running);
        const QPointF before = bench.session.hand()->pointer();
        QTest::keyClick(&window, Qt::Key_Right);
        QTest::keyClick(&window, Qt::Key_Up, Qt::ShiftModifier);
        QCOMPARE(bench.session.hand()->pointer(), before + QPointF(2.0, -10.0));
        bench.session.advance(0.5);
        QTest::keyClick(&window, Qt::Key_W);
        QVERIFY(bench.last().startsWith("The finger is "));
        QTest::keyClick(&window, Qt::Key_P);
        QVERIFY(bench.last().contains("Force |F| now "));
        QTest::keyClick(&window, Qt::Key_Escape);
        QCOMPARE(bench.session.activity()->state(), LabActivity::Stopped);
        QTest::keyClick(&window, Qt::Key_R);
        QVERIFY(bench.session.activity()->recording());
        bench.session.advance(0.1);
        QTest::keyClick(&window, Qt::Key_Escape);
        QCOMPARE(bench.session.files()->recordings().size(), 1);
    }

    void a_screen_reader_turns_every_kind_of_control_and_takes_back() {
        LabBench bench;
        PageWindow window(page, &bench.session);
        QVERIFY(window.exposed());
        QAccessibleInterface* stiffness = window.named("Stiffness K");
        QVERIFY(stiffness != nullptr);
        QCOMPARE(stiffness->valueInterface()->currentValue().toDouble(), 0.2);
        QCOMPARE(stiffness->valueInterface()->maximumValue().toDouble(), 0.5);
        stiffness->valueInterface()->setCurrentValue(0.4);
        QCOMPARE(bench.session.tuning()->parameters().stiffness, 0.4);
        QCOMPARE(bench.last(), QString("Stiffness K: 0.40 newtons per millimetre."));
        QCOMPARE(stiffness->text(QAccessible::Description), QString("0.40 newtons per millimetre"));
        QVERIFY(window.press("Corner cue"));
        QVERIFY(bench.session.tuning()->parameters().corner_cue);
        QVERIFY(window.press("Law: Published Algorithm 1"));
        QCOMPARE(bench.session.tuning()->parameters().law, LawKind::published);
        QVERIFY(window.press("Scene: Triangle, 50 mm high"));
        QCOMPARE(bench.session.scene()->current(), 1);
        QVERIFY(window.press("Undo: the law"));
        QVERIFY(window.press("Undo: Corner cue"));
        QVERIFY(window.press("Undo: Stiffness K"));
        QVERIFY(bench.session.tuning()->parameters() == LabParameters{});
        QCOMPARE(stiffness->valueInterface()->currentValue().toDouble(), 0.2);
    }

    void the_plots_are_sentences_for_a_screen_reader_and_are_drawn() {
        LabBench bench;
        PageWindow window(page, &bench.session);
        QVERIFY(window.exposed());
        QTRY_VERIFY_WITH_TIMEOUT(window.named("Force |F|: nothing measured yet.") != nullptr, 60000); // come after the page
        const QImage before = window.grabWindow();
        bench.hand(43.0, 0.0);
        QVERIFY(window.press("Start the servo"));
        bench.session.advance(3.0);
        for (const QString& sentence : bench.session.plots()->readings())
            QVERIFY2(window.named(sentence) != nullptr, qPrintable(sentence));
        QVERIFY(window.named(bench.session.scene()->fieldWords()) != nullptr);
        const QImage after = window.grabWindow();
        const int top = before.height() * 6 / 10; // where the plots are
        QVERIFY(before.copy(0, top, before.width() / 2, before.height() - top) !=
                after.copy(0, top, after.width() / 2, after.height() - top));
    }

    void mouse_and_finger_move_the_hand() {
        const std::unique_ptr<QPointingDevice> owned(QTest::createTouchDevice());
        QPointingDevice* touch = owned.get();
        LabBench bench;
        PageWindow window(page, &bench.session);
        QVERIFY(window.exposed());
        auto* surface = window.rootObject()->findChild<QQuickItem*>("surface");
        QVERIFY(surface != nullptr);
        const QPoint middle = surface->mapToScene({0.5 * surface->width(), 100.0}).toPoint();
        QTest::mousePress(&window, Qt::LeftButton, {}, middle);
        QVERIFY(std::abs(bench.session.hand()->pointer().x() - 0.5 * bench.session.scene()->surfaceWidth()) < 1.0);
        QTest::mouseMove(&window, middle + QPoint(60, 20));
        QVERIFY(bench.session.hand()->pointer().x() > 0.5 * bench.session.scene()->surfaceWidth() + 5.0);
        QTest::mouseRelease(&window, Qt::LeftButton, {}, middle + QPoint(60, 20));
        QTest::touchEvent(&window, touch).press(0, middle, &window);
        QTRY_VERIFY(std::abs(bench.session.hand()->pointer().x() - 0.5 * bench.session.scene()->surfaceWidth()) < 1.0);
        QTest::touchEvent(&window, touch).move(0, middle + QPoint(0, 40), &window);
        QTest::touchEvent(&window, touch).release(0, middle + QPoint(0, 40), &window);
        QVERIFY(bench.session.activity()->state() == LabActivity::Stopped);
    }

    void a_recording_is_made_and_replayed_by_actions_and_nothing_can_be_turned_meanwhile() {
        LabBench bench;
        PageWindow window(page, &bench.session);
        QVERIFY(window.exposed());
        QVERIFY(window.press("Record"));
        bench.session.advance(0.3);
        QVERIFY(window.named("Reset all parameters, not available") != nullptr);
        QVERIFY(window.press("Stop recording"));
        const QString name = bench.session.files()->recordings().value(0);
        QVERIFY(window.press(QString("Replay %1, 1 of 1").arg(name)));
        QTRY_COMPARE(bench.session.activity()->state(), LabActivity::Replaying);
        bench.session.advance(0.1);
        QVERIFY(window.press("Stop"));
        QVERIFY(window.press("Save the plots as a table"));
        QCOMPARE(QDir(bench.folder.filePath("lab")).entryList({"*.csv"}).size(), 1);
    }

private:
    static void enlarge_text(PageWindow& window, double scale) {
        QQmlComponent component(window.engine());
        component.setData("import QtQml\nimport TouchPhoto.Controls\nQtObject { readonly property var theme: Theme }", {});
        const std::unique_ptr<QObject> holder(component.create());
        QVERIFY(holder != nullptr);
        QVERIFY(holder->property("theme").value<QObject*>()->setProperty("textScale", scale));
    }

    const QString page = "Lab/LabPage.qml";
};

} // namespace lab_page_test

TP_TEST(lab_page_test, LabPageTest, window)
#include "lab_page_test.moc"
